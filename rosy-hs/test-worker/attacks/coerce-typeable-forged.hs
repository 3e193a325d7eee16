import Data.Typeable

data Mine = Mine

instance Typeable Mine where
  typeRep# = undefined

main = simulate (Say "HARM")
