package org.dfra.dist;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * The tarball unpacked in a folder that cannot be written, beside a Java runtime that cannot
 * compile.
 */
final class Installation implements AutoCloseable {

  /** What a command said and how it ended. */
  record Outcome(int exit, String out, String err) {}

  private static final boolean FULL = Boolean.getBoolean("dfra.full");

  /** For a tool that ends before its compiled code is worth the time. */
  private static final Map<String, String> SHORT_LIVED =
      Map.of("JAVA_TOOL_OPTIONS", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC");

  private static final Path ROOT = Path.of(System.getProperty("dfra.root"));
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private final Path folder;
  private final Path java;
  private final Path home;

  /**
   * @param folder a folder of this test alone
   */
  Installation(Path folder) throws IOException, InterruptedException {
    this.folder = folder;
    this.java = runtime(folder.resolve("jre"));
    Path tarball = pack(folder.resolve("out"));
    run(Map.of(), "tar", "-xzf", tarball.toString(), "-C", folder.toString());
    this.home = folder.resolve(tarball.getFileName().toString().replace(".tar.gz", ""));
    run(Map.of(), "chmod", "-R", "a-w", home.toString());
  }

  /** Packs what this build has made; returns the tarball. */
  static Path pack(Path out) throws IOException, InterruptedException {
    return pack(BuiltJars.assumed().lib(), out);
  }

  /** The same with another folder of jars. */
  static Path pack(Path lib, Path out) throws IOException, InterruptedException {
    Outcome packed =
        run(
            Map.of(),
            ROOT.resolve("src/dist/pack").toString(),
            lib.toString(),
            BuiltJars.assumed().boot().toString(),
            out.toString());
    return Path.of(packed.out().strip());
  }

  /** A Java runtime without a compiler, of the Java that runs this. */
  private static Path runtime(Path jre) throws IOException, InterruptedException {
    Path jlink = Path.of(System.getProperty("java.home"), "bin", "jlink");
    assumeTrue(Files.isExecutable(jlink), "the Java that runs the tests has no jlink");
    run(
        FULL ? Map.of() : SHORT_LIVED,
        jlink.toString(),
        "--add-modules",
        "java.se,jdk.crypto.ec,jdk.security.auth,jdk.unsupported",
        "--output",
        jre.toString());
    assertThat(jre.resolve("bin/java")).isExecutable();
    run(Map.of(), jre.resolve("bin/java").toString(), "-Xshare:dump"); // every distribution has it
    assertThat(jre.resolve("bin/javac")).doesNotExist();
    return jre;
  }

  /** The folder that was unpacked. */
  Path home() {
    return home;
  }

  /** The Java runtime. */
  Path java() {
    return java;
  }

  /** Runs the installed command. */
  Outcome dfra(Map<String, String> environment, String... arguments)
      throws IOException, InterruptedException {
    Map<String, String> all = new java.util.HashMap<>(environment);
    all.put("JAVA_HOME", java.toString());
    all.put("DFRA_STATE", folder.resolve("state").toString());
    return start(
        all,
        Stream.concat(Stream.of(home.resolve("bin/dfra").toString()), Arrays.stream(arguments))
            .toArray(String[]::new));
  }

  /** Every process that runs on its Java now. */
  List<ProcessHandle> living() {
    return ProcessHandle.allProcesses()
        .filter(each -> each.info().command().orElse("").startsWith(java.toString()))
        .filter(ProcessHandle::isAlive)
        .toList();
  }

  /** Kills what is left, and lets the folder be deleted. */
  @Override
  public void close() throws IOException, InterruptedException {
    living().forEach(ProcessHandle::destroyForcibly);
    await().atMost(Duration.ofSeconds(10)).until(() -> living().isEmpty());
    run(Map.of(), "chmod", "-R", "u+w", home.toString());
  }

  /** Runs a command that has to end well. */
  static Outcome run(Map<String, String> environment, String... command)
      throws IOException, InterruptedException {
    Outcome outcome = start(environment, command);
    assertThat(outcome.exit()).as(outcome.out() + outcome.err()).isZero();
    return outcome;
  }

  /** Runs a command. */
  static Outcome start(Map<String, String> environment, String... command)
      throws IOException, InterruptedException {
    Path out = Files.createTempFile("dfra-dist", ".out");
    Path err = Files.createTempFile("dfra-dist", ".err");
    try {
      ProcessBuilder builder =
          new ProcessBuilder(command).redirectOutput(out.toFile()).redirectError(err.toFile());
      builder.environment().putAll(environment);
      Process process = builder.start();
      process.getOutputStream().close();
      if (!process.waitFor(PATIENCE.toMillis(), TimeUnit.MILLISECONDS)) {
        process.destroyForcibly();
        throw new AssertionError(
            String.join(" ", command) + " still runs; it said: " + Files.readString(out));
      }
      return new Outcome(
          process.exitValue(),
          Files.readString(out, StandardCharsets.UTF_8),
          Files.readString(err, StandardCharsets.UTF_8));
    } finally {
      Files.delete(out);
      Files.delete(err);
    }
  }
}
