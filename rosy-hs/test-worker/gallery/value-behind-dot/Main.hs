light :: Bumper -> Led1
light (Bumper _ BumperStatus.Pressed) = Led1 LedColor.Red
light _ = Led1 Black

main = simulate light
