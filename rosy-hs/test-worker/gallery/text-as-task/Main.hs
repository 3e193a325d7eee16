main = simulate (mapM say ["a", "b"] >> "c")
