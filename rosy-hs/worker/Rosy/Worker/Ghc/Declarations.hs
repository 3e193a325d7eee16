{-# LANGUAGE GADTs #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Declarations
-- Description : Declarations of a checked program and the functions connected to the robot.
--
-- The declarations with their types, and for each connected function its sensors and commands. Both are read off types; nothing runs.
module Rosy.Worker.Ghc.Declarations
  ( describeDeclarations,
    Spelling (..),
    describeFunctions,
    definitionSpans,
    signatureSpans,
    derivedSpans,
    showType,
  )
where

import Data.Char (isUpper)
import Data.List (nub)
import qualified Data.Map.Strict as Map
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Builtin.Names (eitherTyConKey)
import GHC.Builtin.Types (charTyCon, listTyCon, maybeTyCon, unitTyCon)
import GHC.Core.DataCon (dataConName)
import GHC.Core.TyCo.Rep (Type (..))
import GHC.Core.TyCon (isPromotedDataCon, isTupleTyCon, isVisibleTyConBinder, tyConArity, tyConBinders, tyConDataCons, tyConKind, tyConName)
import GHC.Core.Type
import GHC.Driver.Session (DynFlags)
import GHC.Hs
import GHC.Tc.Types (TcGblEnv (..))
import GHC.Types.Name (getOccString)
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (RdrName, rdrNameOcc)
import GHC.Types.SrcLoc
import GHC.Types.Unique (hasKey)
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Driver (typeEnvIds, typeEnvTyCons)
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.Compat.Types
import Rosy.Worker.Problem (Declaration (..), Function (..), Span (..))

-- | The top-level names of a program with the place of their whole definition, in order.
definitionSpans :: (SrcSpan -> Maybe Span) -> SyntaxTree -> [(Text, Span)]
definitionSpans place parsed = concatMap placed (hsmodDecls parsed)
  where
    placed :: LHsDecl GhcPs -> [(Text, Span)]
    placed (At whole d) = case d of
      ValD _ b -> [(plain n, s) | Just s <- [place whole], n <- boundNames b]
      TyClD _ t@DataDecl {} -> own whole (tcdLName t) ++ concat [[(plain n, s) | Just s <- [place part]] | At part c <- dataConstructors (tcdDataDefn t), n <- constructorNames c]
      TyClD _ t@SynDecl {} -> own whole (tcdLName t)
      TyClD _ t@ClassDecl {} -> own whole (tcdLName t)
      _ -> []
    own whole (L _ n) = [(plain n, s) | Just s <- [place whole]]

-- | The top-level names of a program with the place of their type signature.
signatureSpans :: (SrcSpan -> Maybe Span) -> SyntaxTree -> [(Text, Span)]
signatureSpans place parsed = [(plain n, s) | At whole (SigD _ (TypeSig _ ns _)) <- hsmodDecls parsed, Just s <- [place whole], L _ n <- ns]

-- | The declarations at whose places the compiler writes code of its own.
derivedSpans :: SyntaxTree -> [SrcSpan]
derivedSpans parsed = [at | At at d <- hsmodDecls parsed, derives d]
  where
    derives :: HsDecl GhcPs -> Bool
    derives d = case d of
      TyClD _ DataDecl {} -> True
      DerivD {} -> True
      _ -> False

plain :: RdrName -> Text
plain = Text.pack . occNameString . rdrNameOcc

-- | Every name of 'definitionSpans' that has a type.
describeDeclarations :: DynFlags -> [(Text, Span)] -> TcGblEnv -> [Declaration]
describeDeclarations flags placed checked =
  [Declaration n t s | (n, s) <- placed, Just t <- [Map.lookup n types]]
  where
    env = tcg_type_env checked
    types =
      Map.fromList $
        [(occ (tyConName c), kindText (tyConKind c)) | c <- typeEnvTyCons env]
          ++ [(occ (dataConName d), showType flags (constructorDisplayType flags d)) | c <- typeEnvTyCons env, d <- tyConDataCons c]
          ++ [(occ i, showType flags (varType i)) | i <- typeEnvIds env]
    kindText k = Text.replace "*" "Type" (showType flags k)
    occ x = Text.pack (getOccString x)

-- | Whether types keep the synonyms that the program uses.
data Spelling = AsWritten | SpelledOut
  deriving (Eq)

-- | The functions of these names with their inputs and outputs; names without a type of their own are left out.
describeFunctions :: DynFlags -> Spelling -> [Text] -> TcGblEnv -> [Function]
describeFunctions flags spelling names checked =
  [Function n (concatMap (flatten True) ins) (flatten False out) | n <- nub names, Just t <- [Map.lookup n types], let (ins, out) = arrows t]
  where
    types = Map.fromList [(Text.pack (getOccString i), spelled (varType i)) | i <- typeEnvIds (tcg_type_env checked)]

    spelled t = if spelling == SpelledOut then expandTypeSynonyms t else t
    arrows t = case functionParts (plainly t) of
      Just (_, from, to) -> let (ins, out) = arrows to in (from : ins, out)
      Nothing -> ([], t)
    plainly t = let (_, rho) = splitForAlls (see t) in dropConstraints rho
    dropConstraints t = maybe t plainly (constraintResult t)

    flatten isInput whole = case splitTyConApp_maybe (see whole) of
      Just (c, args)
        | c == unitTyCon -> [showType flags whole | isInput]
        | isTupleTyCon c || c `hasKey` eitherTyConKey || c == maybeTyCon -> concatMap (flatten isInput) args
        | c == listTyCon, [element] <- args, not (isChar element) -> flatten isInput element
      _ | not isInput, Just _ <- functionParts (see whole) -> let (ins, out) = arrows whole in concatMap (flatten True) ins ++ flatten False out
      _ -> [showType flags whole]
    isChar t = fmap fst (splitTyConApp_maybe t) == Just charTyCon
    -- Through a synonym, if it stands for one of the shapes.
    see t = maybe t see (expandSynonym t)

-- | On one line, without module names, and without how often a constructor uses what it holds. Text is always a @String@.
showType :: DynFlags -> Type -> Text
showType flags t = fromMaybe printed (namesOnly t)
  where
    printed = Text.replace "[Char]" "String" . Text.replace " %1 ->" " ->" . Text.unwords . Text.words . Text.pack $ showTypeForUser flags t

-- | The same of a type of words and arrows, as most are. GHC's printer takes ten times as long.
namesOnly :: Type -> Maybe Text
namesOnly t = case t of
  TyConApp c args
    | isWord c, length args == tyConArity c, all isVisibleTyConBinder (tyConBinders c) -> Text.unwords . (Text.pack (getOccString (tyConName c)) :) <$> mapM (fmap bracketed . namesOnly) args
  FunTy {}
    | Nothing <- constraintResult t,
      Just (TyConApp _ [], from, to) <- functionParts t ->
      (\a b -> beforeArrow from a <> " -> " <> b) <$> namesOnly from <*> namesOnly to
  _ -> Nothing
  where
    bracketed a = if Text.any (== ' ') a then "(" <> a <> ")" else a
    beforeArrow from a = case from of
      FunTy {} -> "(" <> a <> ")"
      _ -> a
    isWord c = all isUpper (take 1 (getOccString (tyConName c))) && not (isPromotedDataCon c || isTupleTyCon c || c == listTyCon || isKind c)
    -- Printed as a star.
    isKind c = getOccString (tyConName c) == "Type"
