set(LINKS oblong_models)
