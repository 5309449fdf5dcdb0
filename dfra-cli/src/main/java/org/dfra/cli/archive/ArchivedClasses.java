package org.dfra.cli.archive;

import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.dfra.cli.Main;
import org.dfra.river.bootstrap.EmbeddedRegistrar;
import picocli.CommandLine;

/**
 * The program whose classes the shared archive contains. It loads all classes of DFRA, of JERI and
 * of the libraries that every command uses. For the JDK's classes it shows the help of some
 * commands, and lists the robots of a lookup service of its own, which has none. It connects to
 * that one only, over the loopback interface.
 *
 * <p>The Java virtual machine writes the archive when this ends, and uses it later if the jars are
 * still the same; so an archive is never wrong, at worst useless.
 */
final class ArchivedClasses {

  /** Jars of which every command uses classes. */
  private static final List<String> JARS =
      List.of("dfra-", "jsk-", "picocli-", "logback-", "slf4j-", "jul-to-slf4j-", "jdom2-");

  private static final String LOOPBACK = "127.0.0.1";
  private static final String GROUP = "dfra-archive"; // no command searches it
  private static final Duration LEASE = Duration.ofMinutes(1);

  private ArchivedClasses() {}

  /** Needs no arguments. */
  public static void main(String[] args) throws Exception {
    LoadedClasses.load(JARS);
    for (String verb : List.of("stop", "status", "module")) {
      execute(verb, "--help");
    }
    listRobots();
  }

  private static void execute(String... words) {
    CommandLine line = Main.commandLine(words);
    line.setOut(new PrintWriter(Writer.nullWriter()));
    line.setErr(new PrintWriter(Writer.nullWriter()));
    int unused = line.execute(words);
  }

  /** A command that finds a lookup service and calls it; "stop" would stop this user's robots. */
  private static void listRobots() throws Exception {
    Path state = Files.createTempDirectory("dfra-archive-");
    try (EmbeddedRegistrar registrar =
        new EmbeddedRegistrar(LOOPBACK, 0, List.of(GROUP), LEASE, Map.of()).start()) {
      execute(
          "persona",
          "list",
          "--team=",
          "--host=" + LOOPBACK,
          "--locator=" + LOOPBACK + ":" + registrar.port(),
          "--state=" + state,
          "--wait=1");
    } finally {
      Files.deleteIfExists(state);
    }
  }
}
