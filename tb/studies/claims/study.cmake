# What the sources claim, measured: tests/studies/claims.
set(STUDY_DESIGNS linear circular dda)
set(STUDY_STUDIES comparison)
