data Color = On | Off

blink :: Memory Color -> (Led1, Memory Color)
blink (Memory On) = (Led1 Black, Memory Off)
blink (Memory Off) = (Led1 Green, Memory On)

main = simulate blink
