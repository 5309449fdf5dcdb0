package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.docs.Documents.Document;
import org.junit.jupiter.api.Test;

/** What the documents point to is there. */
class LinksTest {

  private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");

  /** A file or folder of the checkout, written from its top. */
  private static final Pattern FILE =
      Pattern.compile(
          "(?<![\\w/.~-])(?:config|docs|src|benchmarks|\\.ci|\\.mvn|dfra-[a-z]+)/[\\w./-]*[\\w/]");

  /** A module of the build, wherever it is named. */
  private static final Pattern MODULE = Pattern.compile("(?<![\\w./<-])dfra-[a-z]+(?![\\w<-])");

  private static final Pattern CLASS =
      Pattern.compile("(?<![\\w.])org\\.dfra\\.(?:[a-z]\\w*\\.)*[A-Z]\\w*");

  /** A package in backticks, without a class. */
  private static final Pattern PACKAGE = Pattern.compile("`(org\\.dfra(?:\\.[a-z]\\w*)+)`");

  /** The version of the build, as its {@code pom.xml} says it. */
  private static final Pattern VERSION =
      Pattern.compile("<artifactId>dfra</artifactId>\\s*<version>([^<]+)</version>");

  /** Documents that name what has another name now. */
  private static final Set<String> OF_OLD_NAMES =
      Set.of("docs/reference/renamed.md", "CHANGELOG.md");

  /** Names that look like a package's: system properties and a component of the configuration. */
  private static final Set<String> NO_PACKAGES =
      Set.of(
          "org.dfra.group",
          "org.dfra.phoenix.group",
          "org.dfra.phoenix.lock",
          "org.dfra.phoenix.output",
          "org.dfra.river.phoenix.group");

  /**
   * Names that begin like a module: a command, a temporary folder, a module that was split, a peer
   * of a benchmark.
   */
  private static final Set<String> NO_MODULES =
      Set.of("dfra-demo", "dfra-call", "dfra-app", "dfra-tcp", "dfra-tls", "dfra-local");

  @Test
  void everyRelativeLinkLeadsToAFileAndAnHeadingInIt() {
    List<String> broken = new ArrayList<>();
    for (Document document : Documents.all()) {
      LINK.matcher(document.prose())
          .results()
          .map(found -> found.group(1))
          .filter(link -> !link.matches("[a-z]+:.*"))
          .filter(link -> !leadsSomewhere(document, link))
          .forEach(link -> broken.add(document.name() + ": " + link));
    }
    assertThat(broken).as("links that lead nowhere").isEmpty();
  }

  private static boolean leadsSomewhere(Document from, String link) {
    int hash = link.indexOf('#');
    String path = hash < 0 ? link : link.substring(0, hash);
    Path file = path.isEmpty() ? from.file() : from.file().resolveSibling(path).normalize();
    if (!file.startsWith(Documents.ROOT) || !Files.exists(file)) {
      return false;
    }
    return hash < 0
        || new Document(file, Documents.read(file)).anchors().contains(link.substring(hash + 1));
  }

  @Test
  void everyFileThatIsNamedExists() {
    List<String> missing = new ArrayList<>();
    for (Document document : Documents.all()) {
      FILE.matcher(document.text())
          .results()
          .map(found -> found.group())
          .filter(name -> !name.matches(".*/(target|build)(/.*)?"))
          .filter(name -> !Files.exists(Documents.ROOT.resolve(name)))
          .filter(name -> !Files.exists(document.file().resolveSibling(name)))
          .forEach(name -> missing.add(document.name() + ": " + name));
    }
    assertThat(missing).as("files that are named and do not exist").isEmpty();
  }

  @Test
  void everyModuleThatIsNamedExists() {
    List<String> missing = new ArrayList<>();
    for (Document document : Documents.all()) {
      MODULE
          .matcher(document.text())
          .results()
          .map(found -> found.group())
          .filter(name -> !NO_MODULES.contains(name))
          .filter(name -> !Files.isDirectory(Documents.ROOT.resolve(name)))
          .forEach(name -> missing.add(document.name() + ": " + name));
    }
    assertThat(missing).as("modules that are named and do not exist").isEmpty();
  }

  @Test
  void everyClassThatIsNamedExists() throws IOException {
    Set<String> classes = classes();
    assertThat(classes).contains("org.dfra.module.Module", "org.dfra.docs.LinksTest");
    List<String> missing = new ArrayList<>();
    for (Document document : Documents.all()) {
      CLASS
          .matcher(document.text())
          .results()
          .map(found -> found.group())
          .filter(name -> !classes.contains(name))
          .forEach(name -> missing.add(document.name() + ": " + name));
    }
    assertThat(missing).as("classes that are named and do not exist").isEmpty();
  }

  @Test
  void everyPackageThatIsNamedExists() throws IOException {
    Set<String> packages = new HashSet<>();
    for (String name : classes()) {
      for (int dot = name.lastIndexOf('.'); dot > 0; dot = name.lastIndexOf('.', dot - 1)) {
        packages.add(name.substring(0, dot));
      }
    }
    assertThat(packages).contains("org.dfra.module", "org.dfra.docs");
    List<String> missing = new ArrayList<>();
    for (Document document : Documents.all()) {
      if (!OF_OLD_NAMES.contains(document.name().replace('\\', '/'))) {
        PACKAGE
            .matcher(document.text())
            .results()
            .map(found -> found.group(1))
            .filter(name -> !packages.contains(name))
            .filter(name -> !NO_PACKAGES.contains(name))
            .forEach(name -> missing.add(document.name() + ": " + name));
      }
    }
    assertThat(missing).as("packages that are named and do not exist").isEmpty();
  }

  /** A typed version is wrong after the next release. */
  @Test
  void onlyTheChangelogAndTheBenchmarksTypeTheVersion() {
    Matcher version = VERSION.matcher(Documents.read(Documents.ROOT.resolve("pom.xml")));
    assertThat(version.find()).as("pom.xml says the version").isTrue();
    assertThat(Documents.all())
        .filteredOn(document -> !document.name().equals("CHANGELOG.md"))
        .filteredOn(document -> !document.name().startsWith("benchmarks"))
        .as("documents that type version %s", version.group(1))
        .filteredOn(document -> document.text().contains(version.group(1)))
        .extracting(Document::name)
        .isEmpty();
  }

  private static Set<String> classes() throws IOException {
    Pattern source = Pattern.compile(".*/java/(org/dfra/.*)\\.java");
    try (Stream<Path> files = Files.walk(Documents.ROOT, 14)) {
      return files
          .map(file -> source.matcher(file.toString().replace('\\', '/')))
          .filter(Matcher::matches)
          .map(found -> found.group(1).replace('/', '.'))
          .collect(Collectors.toSet());
    }
  }
}
