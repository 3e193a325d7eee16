import Rosy.Launch

main = onPipe 3 undefined undefined [] [] (simulate (Velocity 0 0))
