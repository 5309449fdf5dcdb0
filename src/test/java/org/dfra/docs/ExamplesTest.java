package org.dfra.docs;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationID;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationProvider;
import net.jini.export.Exporter;
import org.dfra.river.call.ResurrectingExporter;
import org.dfra.river.server.Exporters.ServerSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the documents show is code that works. */
class ExamplesTest {

  private static final Pattern JAVA = Pattern.compile("(?ms)^```java\\n(.*?)^```$");
  private static final Pattern BLOCK = Pattern.compile("(?ms)^```\\n(import .*?)^```$");

  private static final Pattern CLASS =
      Pattern.compile("(?m)^(?:public |final )*(?:class|interface|record|enum) (\\w+)");

  private static final Pattern IMPORT = Pattern.compile("(?m)^import (?:static )?[\\w.*]+;\\n");

  /** Their readers copy what they show into a file of their own, so they show the imports too. */
  private static final Path HOW_TOS = Documents.ROOT.resolve("docs/how-to");

  /** What a reader's editor would import. */
  private static final String IMPORTS =
      Stream.of(
              "java.nio.file.Path",
              "java.time.Duration",
              "java.time.Instant",
              "java.util.List",
              "org.dfra.behaviors.fuzzy.*",
              "org.dfra.behaviors.raster.*",
              "org.dfra.core.query.*",
              "org.dfra.directory.*",
              "org.dfra.event.*",
              "org.dfra.flow.effector.*",
              "org.dfra.flow.effector.DriveCommand.*",
              "org.dfra.flow.sensor.*",
              "org.dfra.geometry.GeoPosition",
              "org.dfra.lease.ModuleLease",
              "org.dfra.module.Module",
              "org.dfra.persona.*",
              "org.dfra.river.filter.SerialFilters",
              "org.dfra.river.loading.*",
              "org.dfra.river.lookup.JiniModuleDirectory",
              "org.dfra.sim.physics.*",
              "org.dfra.sim.run.Simulation",
              "org.dfra.sim.time.LockStep",
              "org.dfra.sim.world.*",
              "org.dfra.sim.world.description.WorldDescription",
              "org.dfra.sim.world.file.WorldXml")
          .map(name -> "import " + name + ";\n")
          .reduce("", String::concat);

  /** What an example may take as given. */
  private static final String GIVEN =
      "String host, java.util.List<String> groups, java.util.List<String> locators,"
          + " org.dfra.geometry.GeoPosition here, org.dfra.flow.sensor.GPSSensor receiver,"
          + " org.dfra.flow.effector.DriveEffector drive,"
          + " org.dfra.sim.world.description.WorldDescription field, java.time.Instant start,"
          + " java.nio.file.Path folder";

  @TempDir Path folder;

  /** A block of Java, and the document it stands in. */
  private record Piece(Path file, String java) {

    boolean isClass() {
      return CLASS.matcher(java).find();
    }

    boolean showsItsImports() {
      return file.startsWith(HOW_TOS);
    }

    /** A class around its statements. */
    String source() {
      String own = IMPORT.matcher(java).results().map(MatchResult::group).collect(joining());
      return (showsItsImports() ? own : IMPORTS + own)
          + "class Example {\n void example("
          + GIVEN
          + ") throws Exception {\n"
          + IMPORT.matcher(java).replaceAll("")
          + "}\n}\n";
    }
  }

  /** Those of tutorials are whole programs, which {@link TutorialIT} compiles and runs. */
  private static List<Piece> pieces() {
    return Documents.all().stream()
        .filter(document -> !document.file().startsWith(TutorialIT.TUTORIALS))
        .flatMap(
            document ->
                JAVA.matcher(document.text())
                    .results()
                    .map(found -> new Piece(document.file(), found.group(1))))
        .toList();
  }

  @Test
  void everyHowToShowsTheImportsOfItsJava() {
    List<Piece> shown = pieces().stream().filter(Piece::showsItsImports).toList();
    assertThat(shown).isNotEmpty();
    assertThat(shown).allSatisfy(piece -> assertThat(piece.java()).startsWith("import "));
  }

  @Test
  void everyWholeClassStandsInASourceThatIsTested() throws Exception {
    for (Piece piece : pieces()) {
      Matcher declared = CLASS.matcher(piece.java());
      if (declared.find()) {
        String name = declared.group(1) + ".java";
        try (Stream<Path> files = Files.walk(Documents.ROOT.resolve("src/test/java"))) {
          assertThat(files.filter(file -> file.endsWith(name)).map(Documents::read))
              .as("sources called " + name)
              .anySatisfy(source -> assertThat(source).contains(piece.java()));
        }
      }
    }
  }

  @Test
  void everyPieceOfJavaCompiles() throws Exception {
    List<Piece> pieces = pieces().stream().filter(piece -> !piece.isClass()).toList();
    assertThat(pieces).isNotEmpty();
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    assumeTrue(compiler != null, "this Java has no compiler");
    // One for all, which opens each jar once.
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      for (Piece piece : pieces) {
        Path own = Files.createTempDirectory(folder, "example");
        Path source = Files.writeString(own.resolve("Example.java"), piece.source());
        DiagnosticCollector<JavaFileObject> found = new DiagnosticCollector<>();
        boolean compiled =
            compiler
                .getTask(
                    null,
                    files,
                    found,
                    List.of(
                        "-d",
                        own.toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        "-proc:none"),
                    null,
                    files.getJavaFileObjects(source))
                .call();
        assertThat(compiled).as("%s\n%s", piece.java(), found.getDiagnostics()).isTrue();
      }
    }
  }

  @Test
  void theModulesConfigurationIsReadAndMeansWhatItSays() throws Exception {
    String text = Documents.of("docs/reference/module-configuration.md").text();
    String block = BLOCK.matcher(text).results().map(found -> found.group(1)).findFirst().get();
    Path file = Files.writeString(folder.resolve("module.config"), block);
    Configuration read = ConfigurationProvider.getInstance(new String[] {file.toString()});

    Object exporter =
        read.getEntry(
            "org.dfra.river.server",
            "serverExporter",
            Exporter.class,
            null,
            new ServerSettings(new ActivationID(null), "127.0.0.1"));

    assertThat(exporter).isInstanceOf(ResurrectingExporter.class);
    assertThat(read.getEntry("org.dfra.river.lease", "longestLease", long.class)).isEqualTo(10000L);
    assertThat(read.getEntry("org.dfra.river.lease", "defaultLease", long.class)).isEqualTo(5000L);
  }
}
