{-# LANGUAGE LambdaCase #-}
{-# LANGUAGE OverloadedStrings #-}
{-# LANGUAGE RankNTypes #-}
{-# LANGUAGE ScopedTypeVariables #-}

-- |
-- Module      : Rosy.Worker.Ghc.Read
-- Description : From a program's text to its tree, and what no program may have in it.
module Rosy.Worker.Ghc.Read
  ( -- * Reading
    optionsOf,
    readProgram,

    -- * Refusing
    Guard (..),
    refusalsIn,
    unsafeImports,
    linesWith,

    -- * For the type checker
    summaryOf,
    parsedModule,
  )
where

import Control.Exception (evaluate, try)
import Data.Char (isAlpha, isDigit)
import Data.Data (Data, cast, gmapQ)
import qualified Data.IntSet as IntSet
import Data.Text (Text)
import qualified Data.Text as Text
import Data.Time.Calendar (fromGregorian)
import Data.Time.Clock (UTCTime (..))
import GHC.Data.Bag (bagToList)
import GHC.Data.FastString (mkFastString)
import GHC.Data.StringBuffer (StringBuffer, stringToStringBuffer)
import GHC.Driver.Finder (findImportedModule)
import GHC.Driver.Main (hscCheckSafe)
import GHC.Driver.Session (DynFlags (..), mkHomeModule, parseDynamicFilePragma)
import GHC.Driver.Types
import GHC.Hs hiding (Warning)
import GHC.Parser (parseModule)
import GHC.Parser.Annotation (ApiAnns (..))
import GHC.Parser.Header (getOptions)
import GHC.Parser.Lexer (P (unP), ParseResult (..), getErrorMessages, getMessages, mkPState)
import GHC.Types.Name.Occurrence (occNameString)
import GHC.Types.Name.Reader (isQual, rdrNameOcc)
import GHC.Types.SrcLoc
import GHC.Unit.Module (mkModuleName, moduleNameString)
import GHC.Unit.Module.Location (ModLocation (..))
import Rosy.Worker.Allow
import Rosy.Worker.Ghc.Describe
import Rosy.Worker.Ghc.Report
import Rosy.Worker.Place (Columns)
import Rosy.Worker.Problem (Place (..), Problem, Span (..), problemAt, problemNowhere)
import Rosy.Worker.Raw (Raw (..))

-- | What limits what a program may import and switch on: our lists and Safe Haskell, Safe Haskell alone, or nothing. Only tests of
-- one protection go without another.
data Guard = Guarded | OnlySafe | Unguarded
  deriving (Eq)

-- | The flags after the pragmas at the top of the file, or why one of them is refused.
optionsOf :: Guard -> DynFlags -> Columns -> Text -> StringBuffer -> IO (Either [Problem] DynFlags)
optionsOf guarded _ _ source _ | guarded == Guarded, found@(_ : _) <- placeRefusals source = pure (Left found)
optionsOf guarded flags columns _ buffer = do
  attempt <- try $ do
    let options = getOptions flags buffer fileName
    mapM_ (evaluate . length . unLoc) options
    case if guarded == Guarded then concatMap refusal options else [] of
      [] -> do
        (changed, _, _) <- parseDynamicFilePragma flags options
        pure (Right changed)
      found -> pure (Left found)
  case attempt of
    Right answer -> pure answer
    Left e -> pure (Left [optionProblem (fromParser flags columns m) | m <- bagToList (srcErrorMessages e)])
  where
    refusal (L at option) = case option of
      '-' : 'X' : extension
        | isAllowedExtension (Text.pack extension) -> []
        | otherwise -> [at `sayWith` ("extension", refuseExtension (Text.pack extension))]
      _ -> [at `sayWith` ("options", refuseOptions)]
    sayWith at (k, (m, h)) = say columns at k m h
    optionProblem raw =
      let (m, h) = refuseUnknown (Text.strip (snd (Text.breakOnEnd "Unsupported extension:" (Text.concat (take 1 (Text.lines (Text.concat (important raw))))))))
       in maybe (problemNowhere "extension") (`problemAt` "extension") (region raw) m h

-- | What would make the compiler believe that a text stands elsewhere than it does. Problems would be shown at the wrong place, and
-- 'linesWith' would look there.
placeRefusals :: Text -> [Problem]
placeRefusals source = [problemAt (Span (Place n 1) (Place n (Text.length l + 1))) "pragma" "A program cannot say on which line it stands." "Remove this line." | (n, l) <- numbered, n `elem` hashes ++ pragmas]
  where
    numbered = zip [1 ..] (Text.lines source)
    hashes = [n | (n, l) <- numbered, Just rest <- [Text.stripPrefix "#" l], let word = Text.stripStart rest, Text.any isDigit (Text.take 1 word) || "line" `Text.isPrefixOf` word]
    pragmas = [1 + Text.count "\n" before | (before, after) <- Text.breakOnAll "{-#" source, Text.toLower (Text.takeWhile isAlpha (Text.stripStart (Text.drop 3 after))) `elem` ["line", "column"]]

-- | The tree of a program with warnings about its text, or what keeps it from being read.
readProgram :: DynFlags -> Columns -> StringBuffer -> Either [Raw] (Located HsModule, [Raw])
readProgram flags columns buffer = case unP parseModule (mkPState flags buffer (mkRealSrcLoc (mkFastString fileName) 1 1)) of
  POk state tree
    | errors@(_ : _) <- bagToList (getErrorMessages state flags) -> Left (map (fromParser flags columns) errors)
    | otherwise -> Right (tree, map (fromParser flags columns) (bagToList (fst (getMessages state flags))))
  PFailed state -> Left (map (fromParser flags columns) (bagToList (getErrorMessages state flags)))

fileName :: FilePath
fileName = "Main.hs"

say :: Columns -> SrcSpan -> Text -> Text -> Text -> Problem
say columns s k m h = maybe (problemNowhere k m h) (\p -> problemAt p k m h) (placeOf columns s)

-- | All that no program may have in it, whatever its types are.
refusalsIn :: Columns -> Text -> HsModule -> [Problem]
refusalsIn columns source parsed = importRefusals columns parsed ++ declarationRefusals columns source parsed ++ nameRefusals columns (linesWith refusedNames source) parsed

-- | Imports that neither our list nor Safe Haskell trusts. The list has modules that Safe Haskell cannot judge, Rosy among them.
unsafeImports :: HscEnv -> Columns -> HsModule -> IO [Problem]
unsafeImports env columns parsed = concat <$> mapM judged (hsmodImports parsed)
  where
    judged (L s i) = do
      found <- findImportedModule env (unLoc (ideclName i)) Nothing
      safe <- case found of
        Found _ m -> hscCheckSafe env m s
        -- The type checker says that there is no such module.
        _ -> pure True
      let name = Text.pack (moduleNameString (unLoc (ideclName i)))
          (m, h) = refuseModule name
      pure [say columns s "import" m h | not safe, not (isAllowedModule name)]

importRefusals :: Columns -> HsModule -> [Problem]
importRefusals columns parsed =
  [ say columns s "import" m h
    | L s i <- hsmodImports parsed,
      let wanted = Text.pack (moduleNameString (unLoc (ideclName i))),
      not (isAllowedModule wanted),
      let (m, h) = refuseModule wanted
  ]

-- | Whether a place has a line with one of these words. Looking at text is quick, walking through trees is not.
linesWith :: [Text] -> Text -> SrcSpan -> Bool
linesWith words' source = \case
  RealSrcSpan s _ -> maybe False (<= srcSpanEndLine s) (IntSet.lookupGE (srcSpanStartLine s) found)
  UnhelpfulSpan _ -> False
  where
    -- Once for all places: hence the lambda.
    found = IntSet.fromDistinctAscList [n | any (`Text.isInfixOf` source) words', (n, l) <- zip [1 ..] (Text.lines source), any (`Text.isInfixOf` l) words']

-- | Declarations that have no place in a robot program, whatever the extensions say.
declarationRefusals :: Columns -> Text -> HsModule -> [Problem]
declarationRefusals columns source parsed = concatMap refusal (hsmodDecls parsed)
  where
    lineAt s = case s of
      RealSrcSpan r _ -> Text.concat (take 1 (drop (srcSpanStartLine r - 1) (Text.lines source)))
      UnhelpfulSpan _ -> Text.empty
    noDefinition ws = case ws of
      f : ":" : _ -> ("Two colons stand between a name and its type.", "Write: " <> f <> " :: …")
      w : _ | w `elem` ["def", "function", "func", "fun", "var", "const", "void"] -> ("‘" <> w <> "’ means nothing in Haskell.", "A definition is a name, an equals sign and a value: move = Velocity 0.5 0.")
      _ -> ("This line has no equals sign.", "A definition is a name, an equals sign and a value: move = Velocity 0.5 0.")
    refusal (L s d) = case d of
      ForD {} -> [say columns s "foreign" "A program cannot call functions of other languages." "A robot program is all Haskell."]
      SpliceD {} -> [uncurry (say columns s "missing-equals") (noDefinition (Text.words (lineAt s)))]
      RuleD {} -> [say columns s "pragma" "A program cannot change how it is compiled." "Remove these rules."]
      AnnD {} -> [say columns s "pragma" "A program cannot change how it is compiled." "Remove this annotation."]
      _ -> []

-- | Functions of the Prelude that reach out of the program, under whatever qualifier. A program's own function of that name is
-- another matter.
nameRefusals :: Columns -> (SrcSpan -> Bool) -> HsModule -> [Problem]
nameRefusals columns suspicious parsed = concat [gmapQ' d | d <- hsmodDecls parsed, suspicious (getLoc d)]
  where
    gmapQ' d = concat (gmapQ uses d)
    own = map fst (definitionSpans (placeOf columns) parsed)
    uses :: Data a => a -> [Problem]
    uses x = case cast x of
      Just (L s (HsVar _ (L _ n)) :: LHsExpr GhcPs)
        | used <- Text.pack (occNameString (rdrNameOcc n)),
          Just (m, h) <- refuseName used,
          isQual n || used `notElem` own ->
          [say columns s "not-allowed" m h]
      _ -> concat (gmapQ uses x)

summaryOf :: DynFlags -> Text -> ModSummary
summaryOf flags source =
  ModSummary
    { ms_mod = mkHomeModule flags (mkModuleName "Main"),
      ms_hsc_src = HsSrcFile,
      ms_location = ModLocation {ml_hs_file = Just fileName, ml_hi_file = "Main.hi", ml_obj_file = "Main.o", ml_hie_file = "Main.hie"},
      ms_hs_date = UTCTime (fromGregorian 2000 1 1) 0,
      ms_obj_date = Nothing,
      ms_iface_date = Nothing,
      ms_hie_date = Nothing,
      ms_parsed_mod = Nothing,
      ms_srcimps = [],
      ms_textual_imps = [],
      ms_hspp_file = fileName,
      ms_hspp_opts = flags,
      ms_hspp_buf = Just (stringToStringBuffer (Text.unpack source))
    }

parsedModule :: Located HsModule -> HsParsedModule
parsedModule tree = HsParsedModule tree [] (ApiAnns mempty Nothing mempty mempty)
