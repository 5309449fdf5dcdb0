package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The main sources use the field's terms, not a language of their own. Two lists: words that stand
 * nowhere, and words that stand in no name but are ordinary English in a comment. String literals
 * are not checked yet.
 */
class WordsTest {

  /** In comments and in names. */
  private static final Set<String> NOWHERE =
      Set.of(
          "anew", "baton", "deed", "heard", "hears", "helm", "knock", "knocked", "knocks", "lots",
          "obey", "obeyed", "obeys", "told", "whoever");

  /** In names. */
  private static final Set<String> IN_NO_NAME =
      Set.of("apart", "been", "errand", "errands", "letters", "pursuit", "seat", "tell", "tells");

  /** What stays, each with its reason: file and name or word. */
  private static final Map<String, String> ALLOWED =
      Map.of(
          "Ledger.java heard",
          "component of a record in the agents' stored snapshots; renamed with an alias for them");

  /** A literal or a comment. */
  private static final Pattern TOKEN =
      Pattern.compile(
          "\"\"\"(?s:.)*?\"\"\"|\"(?:\\\\.|[^\"\\\\\\n])*\"|'(?:\\\\.|[^'\\\\\\n])*'"
              + "|//[^\\n]*|/\\*(?s:.)*?\\*/");

  private static final Pattern NAME = Pattern.compile("\\b[A-Za-z_]\\w*\\b");
  private static final Pattern WORD = Pattern.compile("[a-z]+|[A-Z][a-z]*");
  private static final Pattern CODE = Pattern.compile("\\{@(?:code|link|linkplain)\\s[^}]*\\}");

  @Test
  void noBannedWordStandsInTheMainSources() throws IOException {
    List<Path> sources = mainSources();
    assertThat(sources).as("main sources").hasSizeGreaterThan(1000);
    Set<String> found = new TreeSet<>();
    for (Path each : sources) {
      found.addAll(banned(each.getFileName().toString(), Files.readString(each)));
    }
    found.removeAll(ALLOWED.keySet());
    assertThat(found)
        .as("banned words; docs/reference/glossary.md has the project's terms")
        .isEmpty();
  }

  @Test
  void whatIsAllowedIsStillThere() throws IOException {
    Set<String> found = new TreeSet<>();
    for (Path each : mainSources()) {
      found.addAll(banned(each.getFileName().toString(), Files.readString(each)));
    }
    assertThat(found).as("allowed words that are gone can be struck").containsAll(ALLOWED.keySet());
  }

  @Test
  void findsWordsInNamesAndCommentsButNotInLiterals() {
    assertThat(banned("A.java", "int lastHeard; // it was told\nString s = \"told heard\";"))
        .containsExactly("A.java heard", "A.java told");
    assertThat(banned("A.java", "void tellAll() {} // letters and tells"))
        .containsExactly("A.java tell");
    assertThat(banned("A.java", "/** {@code told} stays. */ int seats;")).isEmpty();
  }

  /** The banned words of a source, each after the file's name. */
  private static Set<String> banned(String file, String source) {
    Set<String> found = new TreeSet<>();
    StringBuilder code = new StringBuilder();
    Matcher token = TOKEN.matcher(source);
    int end = 0;
    while (token.find()) {
      code.append(source, end, token.start()).append(' ');
      end = token.end();
      if (token.group().startsWith("/")) {
        for (String word : words(CODE.matcher(token.group()).replaceAll(" "))) {
          if (NOWHERE.contains(word)) {
            found.add(file + " " + word);
          }
        }
      }
    }
    code.append(source, end, source.length());
    for (String word : words(code)) {
      if (NOWHERE.contains(word) || IN_NO_NAME.contains(word)) {
        found.add(file + " " + word);
      }
    }
    return found;
  }

  /** The words of names or of prose, in small letters: {@code lastSeen} has two. */
  private static Set<String> words(CharSequence text) {
    Set<String> words = new TreeSet<>();
    NAME.matcher(text)
        .results()
        .flatMap(name -> WORD.matcher(name.group()).results())
        .forEach(word -> words.add(word.group().toLowerCase(Locale.ROOT)));
    return words;
  }

  private static List<Path> mainSources() throws IOException {
    List<Path> sources = new ArrayList<>();
    try (Stream<Path> top = Files.list(Repository.root())) {
      for (Path module : top.filter(each -> each.resolve("src/main").toFile().exists()).toList()) {
        try (Stream<Path> files = Files.walk(module.resolve("src/main"))) {
          files.filter(file -> file.toString().endsWith(".java")).forEach(sources::add);
        }
      }
    }
    return sources;
  }
}
