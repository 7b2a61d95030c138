find_package(rapidcheck REQUIRED)
<<<<<<< HEAD
set(LINKS oblong_methods rapidcheck)
=======
set(LINKS oblong_fixed rapidcheck)
set(APART ALL)
>>>>>>> main
