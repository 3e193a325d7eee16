main = simulate light

data Mode = Go | Stop | Turn

light :: Memory Mode -> Led1
light (Memory m) = case m of
  Go -> Led1 Green
  Stop -> Led1 Red
