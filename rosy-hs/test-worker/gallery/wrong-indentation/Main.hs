main = simulate light

light :: Bumper -> Led1
light (Bumper _ s) = case s of
Pressed -> Led1 Red
Released -> Led1 Green
