numbers :: [Double]
numbers = [0x1F, 0o17, 1e3, 2.5e-2, 1.0E+2, 007, 3.14159]

main = simulate (Say (show numbers))
