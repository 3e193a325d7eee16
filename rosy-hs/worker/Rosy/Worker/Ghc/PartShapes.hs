-- |
-- Module      : Rosy.Worker.Ghc.PartShapes
-- Description : Shapes of the inputs and outputs of functions, from their types.
--
-- Follows tuples, Either, Maybe and lists down to the types that are sensed or commanded.
module Rosy.Worker.Ghc.PartShapes
  ( Context (..),
    isTaskType,
    arrows,
    inputShape,
    inputsOfOutput,
  )
where

import Data.List (find)
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Builtin.Names (eitherTyConKey)
import GHC.Builtin.Types (charTyCon, listTyCon, maybeTyCon, unitTyCon)
import GHC.Core.TyCon (TyCon, isTupleTyCon, tyConName)
import GHC.Core.Type
import GHC.Types.Name (getOccString)
import GHC.Types.SrcLoc
import GHC.Types.Unique (hasKey)
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Graph
import Rosy.Worker.Problem (Span)

-- | What is fixed for a program.
data Context = Context
  { shown :: Type -> Text,
    place :: SrcSpan -> Maybe Span,
    typeAt :: SrcSpan -> Maybe Type,
    -- | Whether a type is declared by the program.
    isDeclared :: TyCon -> Bool,
    -- | Classes of the robot's topics and the declared types that have an instance of their own.
    onTopics :: [(String, String)],
    -- | Those of them that the program writes itself.
    connections :: [Connection]
  }

isTaskType :: Context -> Type -> Bool
isTaskType context t = case splitTyConApp_maybe (see t) of
  Just (c, _) -> getOccString (tyConName c) == "Task" && not (isDeclared context c)
  Nothing -> False

-- | Through synonyms.
see :: Type -> Type
see t = maybe t see (expandSynonym t)

-- | The arguments and the result of a function, without type variables and constraints.
arrows :: Type -> ([Type], Type)
arrows t = case functionParts rho of
  Just (_, from, to) -> let (ins, out) = arrows to in (from : ins, out)
  Nothing -> ([], rho)
  where
    rho = dropConstraints (snd (splitForAlls (see t)))
    dropConstraints u = maybe u (dropConstraints . snd . splitForAlls . see) (constraintResult u)

inputShape :: Context -> Type -> Shape
inputShape context t = case splitTyConApp_maybe (see t) of
  Just (c, args)
    | c == unitTyCon -> leafShape context Taken t
    | isTupleTyCon c -> AllOf (map (inputShape context) args)
    | c `hasKey` eitherTyConKey -> EitherOf (map (inputShape context) args)
    | c == maybeTyCon, [x] <- args -> MaybeOf (inputShape context x)
  _ -> leafShape context Taken t

-- | The shape of an output, and the inputs of functions in it.
inputsOfOutput :: Context -> Type -> ([Type], Shape)
inputsOfOutput context t = case splitTyConApp_maybe (see t) of
  Just (c, args)
    | c == unitTyCon -> ([], AllOf [])
    | isTupleTyCon c -> AllOf <$> mapM (inputsOfOutput context) args
    | c `hasKey` eitherTyConKey -> EitherOf <$> mapM (inputsOfOutput context) args
    | c == maybeTyCon, [x] <- args -> MaybeOf <$> inputsOfOutput context x
    | c == listTyCon, [x] <- args, fmap fst (splitTyConApp_maybe x) /= Just charTyCon -> EachOf <$> inputsOfOutput context x
  _ | Just _ <- functionParts (see t) -> let (ins, out) = arrows t; (more, result) = inputsOfOutput context out in (ins ++ more, result)
  _ -> ([], leafShape context Sent t)

leafShape :: Context -> ConnectionUse -> Type -> Shape
leafShape context use t = Leaf (shown context t) (shown context (expandTypeSynonyms t)) (isEvent declared) (declared >>= connection)
  where
    declared = case splitTyConApp_maybe (see t) of
      Just (c, _) | isDeclared context c -> Just (getOccString (tyConName c))
      _ -> Nothing
    isEvent = maybe False (\n -> (if use == Taken then "Sensor" else "Command", n) `notElem` onTopics context)
    connection n = find (\c -> connectionUse c == use && connectedType c == Text.pack n) (connections context)
