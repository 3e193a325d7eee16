-- Two events of the program's own: one type with a parameter, sent as two types.
data Alarm = Alarm

newtype Wanted a = Wanted a

watch :: BumperLeft -> Alarm
watch _ = Alarm

plan :: Position -> [Wanted Velocity]
plan _ = [Wanted (Velocity 0.2 0)]

light :: Wanted Led1 -> Led1
light (Wanted led) = led

obey :: Wanted Velocity -> Alarm -> (Velocity, Wanted Led1)
obey (Wanted velocity) Alarm = (velocity, Wanted (Led1 Red))

main = simulate (watch, plan, light, obey)
