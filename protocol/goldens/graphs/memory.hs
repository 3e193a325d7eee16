-- One memory per type and scope, under any variable name; each task has its own scope; one Param for all scopes.
type Hit = Bool

set :: Bumper -> (Memory Hit, Param Int)
set _ = (Memory True, Param 1)

get :: Memory Bool -> Param Int -> Either Velocity Velocity
get (Memory True) _ = Left (Velocity 0 0)
get (Memory False) _ = Right (Velocity 0.1 0)

beside :: Task ()
beside = task (Memory False) (inside, leave)

inside :: Cliff -> Memory Hit
inside _ = Memory True

leave :: Memory Hit -> Param Int -> Maybe (Done ())
leave (Memory hit) _ = if hit then Just (Done ()) else Nothing

main = simulate (set, get, beside)
