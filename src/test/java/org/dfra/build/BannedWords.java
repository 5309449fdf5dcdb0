package org.dfra.build;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds words that the project does not use; {@code docs/reference/glossary.md} has its terms. Some
 * words are banned everywhere: in names, comments, literals and text. Others are ordinary English
 * in a sentence, but say nothing as a name, or as a part of one. Some whole identifiers are banned
 * in one role only. The names of files are checked as those of the types in them.
 */
final class BannedWords {

  /** In names, comments, literals and text. */
  private static final Set<String> EVERYWHERE =
      Set.of(
          "anew",
          "baton",
          "deed",
          "heard",
          "hears",
          "helm",
          "knock",
          "knocked",
          "knocking",
          "knocks",
          "lots",
          "obey",
          "obeyed",
          "obeying",
          "obeys",
          "told",
          "whoever");

  /** As words of names. */
  private static final Set<String> IN_NAMES =
      Set.of(
          "apart", "been", "errand", "errands", "hear", "letters", "pursuit", "seat", "tell",
          "telling", "tells", "tenure");

  /** Whole names: of fields, parameters, variables and methods. */
  private static final Set<String> NAMES =
      Set.of(
          "agenda",
          "amend",
          "atone",
          "chapter",
          "chronicle",
          "depose",
          "dialogue",
          "diary",
          "doubt",
          "dress",
          "examination",
          "gallery",
          "heed",
          "hurry",
          "ledger",
          "lineage",
          "lot",
          "mail",
          "mate",
          "mates",
          "mend",
          "narration",
          "objection",
          "openness",
          "readdress",
          "rehearsal",
          "relieve",
          "rig",
          "room",
          "rooms",
          "said",
          "saying",
          "senses",
          "sightings",
          "stage",
          "stance",
          "story",
          "tally",
          "unretire",
          "venue",
          "vouch",
          "voucher",
          "witness");

  /** Old names of parameters, as whole words of any file. */
  private static final Set<String> OLD_PARAMETERS =
      Set.of("longest_silence", "max_turn_rate", "turns_missed");

  /** Declared types. */
  private static final Pattern TYPES =
      Pattern.compile(
          "\\b(?:class|interface|record|enum)\\s+(Apart|Been|Beside|Deed|Ear|Eye|FlightPicture|"
              + "FlightRest|Gallery|Glance|Facet|HelpRefusedException|HistoryBook|KnownOutcome|Letter|"
              + "LmsErrand|LmsExamination|Look|Loose|LostRegistrar|M12Settlement|Methods|Needed|"
              + "OffLane|Recruiting|Rig|Said|Scout|Seat|Shades|Sightings|SilentPeers|SimulatedLine|Trouble)\\b");

  /** Declared methods: the type of the result stands before the name. */
  private static final Pattern METHODS =
      Pattern.compile("(?:\\w|\\]|(?<!-)>)\\s+(become|maker|opposite|rest|survived)\\s*\\(");

  /** Declared parameters and components: which bias is meant, and what is white? */
  private static final Pattern PARAMETERS =
      Pattern.compile("(?:\\w|\\]|(?<!-)>)\\s+(bias|farthest|white)\\s*(?=[,)])");

  /** A literal or a comment. */
  private static final Pattern TOKEN =
      Pattern.compile(
          "\"\"\"(?s:.)*?\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*+\"|'(?:\\\\.|[^'\\\\\\n])*+'"
              + "|//[^\\n]*|/\\*(?s:.)*?\\*/");

  private static final Pattern IDENTIFIER = Pattern.compile("\\b[A-Za-z_]\\w*\\b");

  private static final Pattern ESCAPE = Pattern.compile("\\\\.");

  private BannedWords() {}

  /** The banned words of a file, each after the file's name. */
  static Set<String> in(String file, String text) {
    Set<String> words = new TreeSet<>();
    addWords(file, word -> EVERYWHERE.contains(word) || IN_NAMES.contains(word), words);
    if (file.endsWith(".java")) {
      addOfJava(text, words);
    } else {
      addWords(text, EVERYWHERE::contains, words);
    }
    for (String name : OLD_PARAMETERS) {
      if (text.contains(name)) {
        words.add(name);
      }
    }
    Set<String> found = new TreeSet<>();
    for (String word : words) {
      found.add(file + " " + word);
    }
    return found;
  }

  private static void addOfJava(String source, Set<String> found) {
    StringBuilder code = new StringBuilder();
    Matcher token = TOKEN.matcher(source);
    int end = 0;
    while (token.find()) {
      code.append(source, end, token.start()).append(' ');
      end = token.end();
      String text = token.group();
      addWords(
          text.startsWith("/") ? text : ESCAPE.matcher(text).replaceAll(" "),
          EVERYWHERE::contains,
          found);
    }
    code.append(source, end, source.length());
    IDENTIFIER
        .matcher(code)
        .results()
        .map(MatchResult::group)
        .filter(NAMES::contains)
        .forEach(found::add);
    addWords(code.toString(), word -> EVERYWHERE.contains(word) || IN_NAMES.contains(word), found);
    for (Pattern declared : List.of(TYPES, METHODS, PARAMETERS)) {
      declared.matcher(code).results().forEach(each -> found.add(each.group(1)));
    }
  }

  /** The banned words of names or of prose, in small letters: {@code lastSeen} has two words. */
  private static void addWords(String text, Predicate<String> banned, Set<String> found) {
    int begin = 0;
    while (begin < text.length()) {
      int end = endOfWord(text, begin);
      if (end > begin) {
        String word = text.substring(begin, end).toLowerCase(Locale.ROOT);
        if (banned.test(word)) {
          found.add(word);
        }
      }
      begin = Math.max(end, begin + 1);
    }
  }

  /** A word is in small letters, also after one capital, or in capitals. */
  private static int endOfWord(String text, int begin) {
    int end = begin;
    while (end < text.length() && text.charAt(end) >= 'A' && text.charAt(end) <= 'Z') {
      end++;
    }
    if (end == text.length() || !isSmall(text.charAt(end))) {
      return end;
    }
    if (end - begin > 1) { // the last capital begins the next word
      return end - 1;
    }
    while (end < text.length() && isSmall(text.charAt(end))) {
      end++;
    }
    return end;
  }

  private static boolean isSmall(char c) {
    return c >= 'a' && c <= 'z';
  }
}
