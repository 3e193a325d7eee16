-- driving school: every function a lesson
lesson1 = simulate (Velocity 0.2 0)
lesson2 = simulate ((\(Velocity a b) -> Velocity a (b + 0.1)) :: Velocity -> Velocity)
lesson3 = simulate (bumpy, lighty) where
  bumpy :: Bumper -> Sound
  bumpy _ = ButtonSound
  lighty :: Button -> Led1
  lighty (Button _ x) = Led1 $ case x of Pressed -> Green
                                         Released -> Black

main = lesson3
