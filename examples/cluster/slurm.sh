#!/bin/bash
#SBATCH --job-name=beamgap
#SBATCH --array=1-100
#SBATCH --cpus-per-task=2
#SBATCH --time=00:30:00
#
# sbatch slurm.sh
# sbatch --dependency=afterany:JOB --wrap 'beamgap merge part-*.json'

# A shard with a mismatch ends with exit code 1, and its part contains it. The merged result contains the verdict.
beamgap check --cases "${CASES:-1000000}" \
    --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
    --threads "$SLURM_CPUS_PER_TASK" \
    --output "json=part-$SLURM_ARRAY_TASK_ID.json"
