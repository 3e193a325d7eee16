{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.ProgramFacts
-- Description : Facts of the parsed tree for "Rosy.Worker.StaticAdvice".
--
-- The declared types, which of their constructors expressions build and patterns match, and the worlds that the program names. Only declarations
-- on whose lines such a constructor or function stands are walked.
module Rosy.Worker.Ghc.ProgramFacts
  ( programFacts,
  )
where

import Data.Data (Data, cast, gmapQ)
import Data.List (nub)
import Data.Text (Text)
import qualified Data.Text as Text
import GHC.Data.Bag (isEmptyBag)
import GHC.Hs
import GHC.Types.Name.Occurrence (isDataOcc, occNameString)
import GHC.Types.Name.Reader (RdrName, isRdrTyVar, isUnqual, rdrNameOcc)
import GHC.Types.SrcLoc
import Rosy.Worker.Ghc.Compat.Declarations
import Rosy.Worker.Ghc.Compat.Syntax
import Rosy.Worker.Ghc.DeclaredTypes (instanceHead)
import Rosy.Worker.Problem (Span)
import Rosy.Worker.StaticAdvice

-- | Takes predicates that select spans with one of these words, and with one of these names in front of an argument, and the names of the
-- functions given to the robot.
programFacts :: (SrcSpan -> Maybe Span) -> ([Text] -> SrcSpan -> Bool) -> ([Text] -> SrcSpan -> Bool) -> [Text] -> SyntaxTree -> Facts
programFacts located mayContain mayApply names parsed =
  Facts
    { declaredTypes = types,
      built = nub [plain n | Built n <- uses],
      matched = [(plain n, s) | Matched at n <- uses, Just s <- [located at]],
      connectedNames = names,
      appliedNames = nub (concat [appliedIn d | d@(At at _) <- hsmodDecls parsed, appliesOne at]),
      namedWorlds = [(Text.pack w, s) | d@(At at _) <- hsmodDecls parsed, namesWorld at, (w, spot) <- worldsIn d, Just s <- [located spot]]
    }
  where
    types = [declared t | L _ (TyClD _ t@DataDecl {}) <- hsmodDecls parsed]
    constructorsOfAll = map constructorName (concatMap constructors types)
    uses = if null constructorsOfAll then [] else filter isOwn (concat [usesIn d | d <- hsmodDecls parsed, isCode (unLoc d), usesOne (spanOf d)])
    -- The text is searched once for all declarations. Walking them all takes as long as checking them.
    usesOne = mayContain constructorsOfAll
    appliesOne = mayApply names
    namesWorld = mayContain [Text.pack "simulateIn"]
    appliedIn :: Data a => a -> [Text]
    appliedIn x = case cast x of
      Just (HsApp _ (L _ (HsVar _ (L _ n))) _ :: HsExpr GhcPs) -> head' n ++ inside x
      Just (OpApp _ (L _ (HsVar _ (L _ n))) (L _ (HsVar _ (L _ op))) _) | plain op == Text.pack "$" -> head' n ++ inside x
      _ -> inside x
    inside :: Data a => a -> [Text]
    inside = concat . gmapQ appliedIn
    head' n = [plain n | plain n `elem` names]
    isOwn u = plain (used u) `elem` constructorsOfAll
    isCode d = case d of
      TyClD _ DataDecl {} -> False
      SigD {} -> False
      _ -> True

    declared :: TyClDecl GhcPs -> DeclaredType
    declared t =
      DeclaredType
        { typeName = name,
          constructors = [Constructor (plain n) (typeNames c) | L _ c <- dataConstructors (tcdDataDefn t), n <- constructorNames c],
          hasOtherSources = any (`notElem` map Text.pack ["Eq", "Ord", "Show", "Generic"]) (map plain (derivedClasses (tcdDataDefn t)) ++ standalone name) || hasInstance "Sensor" name,
          hasOtherTargets = hasInstance "Command" name
        }
      where
        name = plain (unLoc (tcdLName t))
    standalone n = [Text.pack c | L _ d@DerivD {} <- hsmodDecls parsed, (c, t) <- instanceHead d, Text.pack t == n]
    hasInstance c n = or [not (isEmptyBag (cid_binds i)) && (c, Text.unpack n) `elem` instanceHead d | L _ d@(InstD _ (ClsInstD _ i)) <- hsmodDecls parsed]

-- | A constructor in a pattern or anywhere else.
data Use = Matched SrcSpan RdrName | Built RdrName

used :: Use -> RdrName
used u = case u of
  Matched _ n -> n
  Built n -> n

usesIn :: Data a => a -> [Use]
usesIn x
  | Just p <- cast x, ConPat {pat_con = At s n, pat_args = args} <- p :: Pat GhcPs = Matched s n : usesIn args
  | Just n <- cast x = [Built n | isDataOcc (rdrNameOcc n)]
  | otherwise = concat (gmapQ usesIn x)

-- | Applications of @simulateIn@ to a name, with the place of the name.
worldsIn :: Data a => a -> [(String, SrcSpan)]
worldsIn x = case cast x of
  Just (HsApp _ (L _ (HsVar _ (L _ f))) (At at (HsVar _ (L _ w))) :: HsExpr GhcPs)
    | isUnqual f, occNameString (rdrNameOcc f) == "simulateIn" -> [(occNameString (rdrNameOcc w), at)]
  _ -> concat (gmapQ worldsIn x)

-- | The names of the types in a declaration of a constructor.
typeNames :: Data a => a -> [Text]
typeNames x = case cast x of
  Just (HsTyVar _ _ (L _ n) :: HsType GhcPs) -> [plain n | not (isRdrTyVar n)]
  _ -> concat (gmapQ typeNames x)

plain :: RdrName -> Text
plain = Text.pack . occNameString . rdrNameOcc
