package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.awaitility.Awaitility;
import org.dfra.core.host.FreePorts;
import org.dfra.module.Module;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * The tutorials, followed to the letter: their files are written, their commands typed into a
 * shell, and what they say these print is looked for. Only ports and folders are this test's own.
 *
 * <p>In the short form the JVMs of the tools use the first compiler only, and the experiment with a
 * strategy, 1200 runs, is not run.
 */
class TutorialIT {

  /** The folder of the tutorials. */
  static final Path TUTORIALS = Documents.ROOT.resolve("docs/tutorials");

  private static final boolean FULL = Boolean.getBoolean("dfra.full");

  /** For what ends soon; what {@code ./dfra} starts has these options anyway. */
  private static final String SHORT_LIVED = "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC";

  private static final Pattern BLOCK = Pattern.compile("(?ms)^```(\\w+)\\n(.*?)^```$");
  private static final Pattern FILE =
      Pattern.compile("`([\\w-]+(?:/[\\w-]+)*\\.(?:java|properties|xml|geojson))`");

  /** What was compiled, as jars; the same for all tutorials. */
  @TempDir static Path lib;

  @TempDir Path folder;
  private Path work;
  private String phoenixPort;
  private String registrarPort;
  private String classPort;

  @BeforeAll
  static void packLibraries() throws IOException {
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
      Path path = Path.of(entry);
      if (!path.startsWith(Documents.ROOT.resolve("src/test"))) {
        copy(path, lib);
      }
    }
    Path api = Path.of(Module.class.getProtectionDomain().getCodeSource().getLocation().getPath());
    copy(api, Files.createDirectory(lib.resolve("dl")));
  }

  /** Where the reader has a clone, this has what was compiled, under the same names. */
  @BeforeEach
  void prepareAClone() throws IOException {
    work = Files.createDirectory(folder.resolve("my-sensors"));
    phoenixPort = Integer.toString(FreePorts.allocate());
    registrarPort = Integer.toString(FreePorts.allocate());
    classPort = Integer.toString(FreePorts.allocate());
    Files.writeString(folder.resolve("dfra"), launcher());
    assertThat(folder.resolve("dfra").toFile().setExecutable(true)).isTrue();
  }

  /** A jar as it is, a folder of classes as a jar. */
  private static void copy(Path entry, Path to) throws IOException {
    if (Files.isRegularFile(entry)) {
      Files.copy(entry, to.resolve(entry.getFileName()));
    } else if (Files.isDirectory(entry)) { // .../dfra-core/target/classes, or Gradle's
      String name = Documents.ROOT.relativize(entry).toString().replace(File.separator, "-");
      pack(entry, to.resolve(name + ".jar"));
    }
  }

  /** As {@code jar --create} does, of which each would be a process of its own. */
  private static void pack(Path classes, Path jar) throws IOException {
    try (ZipOutputStream out = new ZipOutputStream(Files.newOutputStream(jar));
        Stream<Path> files = Files.walk(classes)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        out.putNextEntry(new ZipEntry(classes.relativize(file).toString()));
        Files.copy(file, out);
        out.closeEntry();
      }
    }
  }

  /** What {@code ./dfra} does at last, which starts the program, with this test's phoenix. */
  private String launcher() {
    return "#!/bin/sh\nset -eu\n"
        + (". '" + Documents.ROOT.resolve("src/dist/libexec/java.sh") + "'\n")
        + ("root='" + Documents.ROOT + "' home='" + System.getProperty("java.home") + "'\n")
        + ("lib='" + lib + "' boot='" + System.getProperty("dfra.boot-class-path") + "'\n")
        + ("export DFRA_STATE='" + folder.resolve("state") + "'\n")
        + (FULL ? "" : "unset JAVA_TOOL_OPTIONS\n")
        + "export DFRA_WAIT=20\n" // a module that is named is not awaited once it is found
        + ("[ $1 != up ] || set -- \"$@\" --port " + phoenixPort + " --registry-port -1\n")
        + "launch \"$root\" \"$lib\" \"$boot\" ./dfra \"$@\"\n";
  }

  @AfterEach
  void takeDown() {
    List<ProcessHandle> left =
        ProcessHandle.allProcesses()
            .filter(each -> runsFrom(each, folder) || runsFrom(each, lib))
            .toList();
    left.forEach(ProcessHandle::destroyForcibly);
    Awaitility.await().until(() -> left.stream().noneMatch(ProcessHandle::isAlive));
  }

  private static boolean runsFrom(ProcessHandle process, Path folder) {
    return process.info().commandLine().orElse("").contains(folder.toString());
  }

  @Test
  void writeYourOwnSensor() throws Exception {
    int looked = follow(text("write-your-own-sensor.md"), work);
    assertThat(looked).as("lines that were looked for").isGreaterThan(5);
    assertThat(written()).as("files of the tutorial").contains("desk.xml", "trust.properties");
  }

  /** Three searches, each as long as the computer needs for it. */
  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "takes minutes")
  void twoRobotsSearchAField() throws Exception {
    int looked = follow(text("two-robots-search-a-field.md"), folder); // where ./dfra is
    assertThat(looked).as("lines that were looked for").isGreaterThan(5);
    assertThat(folder.resolve("reports/raster/report.html")).exists();
  }

  @Test
  void addAStrategy() throws Exception {
    Path in = Files.createDirectory(folder.resolve("my-strategy"));
    String text = text("add-a-strategy.md");
    if (FULL) {
      int looked = follow(text, in);
      assertThat(looked).as("lines that were looked for").isGreaterThan(3);
    } else {
      int experiment = text.indexOf("\"$dfra/dfra\" recruit experiment");
      assertThat(follow(text.substring(0, experiment) + "```\n", in)).as("before it").isZero();
      assertThat(in.resolve("classes/org/example/NearOnesFirst.class")).isNotEmptyFile();
    }
  }

  private static String text(String tutorial) {
    return Documents.read(TUTORIALS.resolve(tutorial));
  }

  /**
   * Does what a tutorial says.
   *
   * @return how many lines of what it says is printed were looked for; those of blocks of {@code
   *     output} differ from run to run and are not
   */
  private int follow(String text, Path in) throws IOException, InterruptedException {
    List<String> exports = new ArrayList<>();
    String printed = "";
    int looked = 0;
    Matcher block = BLOCK.matcher(text);
    while (block.find()) {
      String content = atOwnPorts(block.group(2));
      switch (block.group(1)) {
        case "sh" -> {
          if (content.contains("dfra=~/dfra")) {
            exports.add("export dfra='" + folder + "' lib='" + lib + "'");
            exports.add("export boot='" + System.getProperty("dfra.boot-class-path") + "'");
            continue;
          }
          printed = shell(in, String.join("\n", exports) + "\n" + content);
          content.lines().filter(line -> line.startsWith("export ")).forEach(exports::add);
        }
        case "text" -> {
          for (String line : content.lines().toList()) {
            assertThat(printed).contains(line.replaceFirst("…$", ""));
            looked++;
          }
        }
        case "output" -> {}
        default -> {
          Path file = in.resolve(named(text.substring(0, block.start())));
          Files.createDirectories(file.getParent());
          Files.writeString(file, content);
        }
      }
    }
    return looked;
  }

  private List<String> written() throws IOException {
    try (Stream<Path> files = Files.list(work)) {
      return new ArrayList<>(new TreeSet<>(files.map(each -> each.getFileName() + "").toList()));
    }
  }

  /** The file that the paragraph before a block names last. */
  private static String named(String before) {
    String paragraph = before.strip().substring(before.strip().lastIndexOf("\n\n") + 1);
    return FILE.matcher(paragraph)
        .results()
        .map(found -> found.group(1))
        .reduce((a, b) -> b)
        .orElseThrow(() -> new AssertionError("no file is named in: " + paragraph));
  }

  private String atOwnPorts(String content) {
    return content.replace("4160", registrarPort).replace("8085", classPort);
  }

  /** Runs what a reader types, in a shell that ends at the first failure; gives all it printed. */
  private static String shell(Path in, String commands) throws IOException, InterruptedException {
    Path output = Files.createTempFile(in, "said", ".txt");
    ProcessBuilder shell =
        new ProcessBuilder("sh", "-eu", "-c", commands)
            .directory(in.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile());
    Path java = Path.of(System.getProperty("java.home"), "bin");
    shell.environment().merge("PATH", java.toString(), (path, own) -> own + ":" + path);
    shell.environment().put("PWD", in.toString());
    if (!FULL) {
      shell.environment().merge("JAVA_TOOL_OPTIONS", SHORT_LIVED, (own, ours) -> own + " " + ours);
    }
    Process process = shell.start();
    boolean ended = process.waitFor(240, TimeUnit.SECONDS);
    process.destroyForcibly();
    String printed = Files.readString(output, StandardCharsets.UTF_8);
    Files.delete(output);
    assertThat(ended).as("%s\nstill runs; it said: %s", commands, printed).isTrue();
    assertThat(process.exitValue()).as("%s\nsaid: %s", commands, printed).isZero();
    return printed;
  }
}
