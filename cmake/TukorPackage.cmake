# The installable package: find_package(tukor) gives tukor::<module> targets.
