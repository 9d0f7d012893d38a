//! The module in the committed pages is built from the current library: its answers equal the native answers, byte by
//! byte. `examples/explorer/build` builds the pages again.

use beamgap::test_beam::Family;
use beamgap_explorer::{Dragged, Frame, SCENES, Shown, State, answer, learn, opening, preset};
use serde_json::Value;
use std::io::Read;
use wasmi::{Engine, Instance, Linker, Memory, Module, Store, TypedFunc};

const EXPLORER: &str = "explorer.html";
const LEARN: &str = "learn.html";

/// The running module of the page.
struct Running {
    store: Store<()>,
    memory: Memory,
    reserve: TypedFunc<u32, u32>,
    /// The function that answers.
    respond: TypedFunc<(), u32>,
    answer_at: TypedFunc<(), u32>,
}

fn committed(name: &str) -> String {
    let path = format!("{}/../../reports/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The content of the element with this id.
fn element<'a>(page: &'a str, id: &str) -> &'a str {
    let (_, from) = page.split_once(&format!("id=\"{id}\">")).unwrap();
    from.split("</script>").next().unwrap()
}

impl Running {
    fn of_page(page: &str, function_name: &str) -> Self {
        let bytes = decoded(element(&committed(page), "module"));
        let engine = Engine::default();
        let module = Module::new(&engine, &bytes[..]).unwrap();
        assert_eq!(module.imports().count(), 0, "the module needs nothing from the page");
        let mut store = Store::new(&engine, ());
        let instance: Instance = Linker::new(&engine).instantiate_and_start(&mut store, &module).unwrap();
        let function = |name| instance.get_typed_func(&store, name).unwrap();
        let (respond, answer_at) = (function(function_name), function("answer_at"));
        let reserve = instance.get_typed_func(&store, "reserve").unwrap();
        let memory = instance.get_memory(&store, "memory").unwrap();
        Self { store, memory, reserve, respond, answer_at }
    }

    fn answer(&mut self, request: &str) -> String {
        let length = u32::try_from(request.len()).unwrap();
        let at = self.reserve.call(&mut self.store, length).unwrap();
        self.memory.write(&mut self.store, at as usize, request.as_bytes()).unwrap();
        let length = self.respond.call(&mut self.store, ()).unwrap();
        let at = self.answer_at.call(&mut self.store, ()).unwrap();
        let mut bytes = vec![0; length as usize];
        self.memory.read(&self.store, at as usize, &mut bytes).unwrap();
        String::from_utf8(bytes).unwrap()
    }
}

fn decoded(text: &str) -> Vec<u8> {
    use base64::Engine;
    let compressed = base64::prelude::BASE64_STANDARD.decode(text.trim()).unwrap();
    let mut bytes = Vec::new();
    flate2::read::GzDecoder::new(&compressed[..]).read_to_end(&mut bytes).unwrap();
    bytes
}

/// States of every family, view and fault, and invalid requests.
fn requests() -> Vec<String> {
    let mut requests = Vec::new();
    let mut add = |state: &State| requests.push(serde_json::to_string(state).unwrap());
    add(&State::default());
    for (i, family) in Family::ALL.into_iter().enumerate() {
        let other = Family::ALL[(i + 4) % Family::ALL.len()];
        add(&State { beam: preset(family, false), bar: preset(other, true), ..State::default() });
    }
    for (fault, dragged) in [
        ("a: d.t,xi = dropped", Dragged::Dq),
        ("Ddg_T: dt Dxi = dropped", Dragged::LinearDq),
        ("H_d: a gg' = sign", Dragged::Q),
        ("no such term = sign", Dragged::Q),
    ] {
        add(&State {
            fault: Some(fault.to_owned()),
            dragged,
            along_linear: true,
            step: 0.75,
            ..State::default()
        });
    }
    // Parallel beams, crossing beams, a closest point at an end, and a beam of length zero.
    for (q, q_bar) in [
        ([-1.0, 0.0, 0.25, 1.0, 0.0, 0.25], [-1.0, 0.0, -0.25, 1.0, 0.0, -0.25]),
        ([-1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.0, -1.0, 0.0, 0.0, 1.0, 0.0]),
        ([-1.5, 0.0, 0.25, -0.5, 0.25, 0.25], [0.25, -1.0, -0.25, 0.25, 1.0, -0.25]),
        ([0.5; 6], [0.0, -1.0, 0.0, 0.0, 1.0, 0.0]),
    ] {
        let (mut beam, mut bar) = (preset(Family::Segment, false), preset(Family::Segment, true));
        (beam.q, bar.q) = (q.into(), q_bar.into());
        add(&State { beam, bar, ..State::default() });
    }
    let mut short = State::default();
    short.beam.q.pop();
    add(&short);
    add(&State { step: 2.0, ..State::default() });
    add(&State {
        fault: Some("Dd t: rest = sign".to_owned()),
        shown: Shown::T,
        order: 2,
        ..State::default()
    });
    requests.extend([String::new(), "{}".to_owned(), "no JSON".to_owned(), "{\"colour\":1}".to_owned()]);
    requests
}

/// Requests of every scene: as it opens, with each handle at several places, with each control.
fn scene_requests() -> Vec<String> {
    let mut requests = vec![String::new(), "{\"scene\":\"none\"}".to_owned()];
    for scene in SCENES {
        let request = |action: &str| format!("{{\"scene\":\"{scene}\",\"action\":{action}}}");
        requests.push(request("null"));
        let places = opening(scene).unwrap().places;
        for (handle, place) in &places {
            let Some([x, y]) = place else { continue };
            for [right, down] in [[14.0, -9.0], [-40.0, 25.0], [500.0, 500.0]] {
                let drag =
                    format!("{{\"drag\":{{\"handle\":\"{handle}\",\"to\":[{},{}]}}}}", x + right, y + down);
                requests.push(request(&drag));
            }
        }
        for (name, value) in [
            ("situation", "waves"),
            ("situation", "straight"),
            ("situation", "arcs"),
            ("walk", "end"),
            ("tangent", "frozen"),
            ("tangent", "sign_b"),
            ("push", "0.4"),
            ("check", "0"),
            ("check", "2"),
            ("suspect", "4"),
            ("next", ""),
            ("accept", ""),
        ] {
            let choose = format!("{{\"choose\":{{\"name\":\"{name}\",\"value\":\"{value}\"}}}}");
            requests.push(request(&choose));
        }
    }
    requests
}

/// Pictures of the explorer: the states of the tables, and what a reader does.
fn picture_requests() -> Vec<String> {
    let states = requests().into_iter().filter(|request| request.starts_with('{') && request.len() > 20);
    let mut all: Vec<String> =
        states.map(|state| format!("{{\"scene\":\"explorer\",\"state\":{state}}}")).collect();
    let mut act = |action: &str| all.push(format!("{{\"scene\":\"explorer\",\"action\":{action}}}"));
    act("{\"drag\":{\"handle\":\"b1\",\"to\":[300,120]}}");
    act("{\"push\":{\"handle\":\"r0\",\"by\":-0.3}}");
    for (name, value) in [
        ("situation", "parallel"),
        ("situation", "nearly parallel"),
        ("situation", "crossing"),
        ("situation", "overlap"),
        ("situation", "at an end"),
        ("situation", "two minima"),
        ("lesson", "d|d|: n.du_hat = sign"),
        ("lesson", "Ddg_T: dt Dxi = dropped"),
        ("family-bar", "helix"),
        ("view", "100 -20"),
        ("shown", "rope"),
        ("beam q 2", "0.9"),
    ] {
        act(&format!("{{\"choose\":{{\"name\":\"{name}\",\"value\":\"{value}\"}}}}"));
    }
    all
}

#[test]
fn the_module_draws_like_the_library() {
    let mut running = Running::of_page(EXPLORER, "learn");
    for request in picture_requests() {
        let (native, module) = (learn(&request), running.answer(&request));
        assert_eq!(native, module, "the page is stale, or the platform rounds otherwise: {request}");
    }
}

#[test]
fn the_module_of_the_page_answers_like_the_library() {
    let mut running = Running::of_page(EXPLORER, "respond");
    for request in requests() {
        let (native, module) = (answer(&request), running.answer(&request));
        if native != module {
            let [native, module] = [native, module].map(|text| serde_json::from_str::<Value>(&text).unwrap());
            let differs =
                native.as_object().unwrap().iter().find(|(key, value)| module[key.as_str()] != **value);
            panic!("the page is stale, or the platform rounds otherwise: {differs:#?} for {request}");
        }
    }
}

#[test]
fn the_page_shows_the_standard_case_before_the_module_runs() {
    let page = committed(EXPLORER);
    let answer: Value =
        serde_json::from_str(&answer(&serde_json::to_string(&State::default()).unwrap())).unwrap();
    for piece in ["words", "points", "checks", "prediction", "plot", "numbers", "lesson"] {
        assert!(page.contains(answer[piece].as_str().unwrap()), "{piece} is stale: examples/explorer/build");
    }
    shows(&page, &opening("explorer").unwrap(), "explorer");
    let files = [
        "module.js",
        "scene.js",
        "hands.js",
        "explorer/picture.js",
        "explorer/fault.js",
        "explorer/tables.js",
        "explorer/dofs.js",
        "explorer/link.js",
        "scene.css",
        "explorer/explorer.css",
    ];
    is_complete(&page, &files);
}

/// The page contains these files, needs no other place, and is small enough.
fn is_complete(page: &str, files: &[&str]) {
    for file in files {
        let text = std::fs::read_to_string(format!("{}/page/{file}", env!("CARGO_MANIFEST_DIR"))).unwrap();
        assert!(page.contains(text.trim()), "{file} is stale: examples/explorer/build");
    }
    assert_eq!(page.matches("http://").count(), page.matches("http://www.w3.org/").count());
    assert_eq!(page.matches("https://").count(), 0);
    assert!(page.len() < 1_200_000, "{} bytes", page.len());
}

#[test]
fn the_module_answers_requests_of_scenes_like_the_library() {
    let mut running = Running::of_page(LEARN, "learn");
    for request in scene_requests() {
        let (native, module) = (learn(&request), running.answer(&request));
        assert_eq!(native, module, "the page is stale, or the platform rounds otherwise: {request}");
    }
}

#[test]
fn the_page_of_the_scenes_shows_how_they_open() {
    let page = committed(LEARN);
    for scene in SCENES {
        let frame = opening(scene).unwrap();
        let (_, from) = page.split_once(&format!("data-scene=\"{scene}\"")).unwrap();
        let html = from.split("</section>").next().unwrap();
        shows(html, &frame, scene);
    }
    let files = ["module.js", "scene.js", "hands.js", "scene.css", "learn/walk.js", "learn/learn.css"];
    is_complete(&page, &files);
}

/// The elements of a scene have the content of its frame.
fn shows(html: &str, frame: &Frame, scene: &str) {
    for (name, path) in &frame.paths {
        let is_shown = html.contains(&format!("data-path=\"{name}\" d=\"{path}\""));
        assert!(is_shown, "{scene}: {name} is stale: examples/explorer/build");
    }
    for (name, text) in &frame.values {
        let from = html.split_once(&format!("data-value=\"{name}\"")).map(|(_, from)| from);
        let shown = from.and_then(|from| from.split_once('>')).map(|(_, from)| from.split('<').next());
        // A value that no sentence shows is not needed on the page.
        assert!(
            shown.is_none_or(|shown| shown == Some(text.as_str())),
            "{scene}: {name} is stale: examples/explorer/build"
        );
    }
}
