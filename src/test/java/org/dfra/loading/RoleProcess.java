package org.dfra.loading;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** A process in a {@link Role}. */
final class RoleProcess implements AutoCloseable {

  private static final String ENDED = "";

  private final Process process;
  private final LinkedBlockingQueue<String> said = new LinkedBlockingQueue<>();
  private final StringBuffer output = new StringBuffer();

  /**
   * @param path what is on its class path besides the test's own
   */
  RoleProcess(List<Path> path, List<String> options, String... role) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xbootclasspath/a:" + System.getProperty("dfra.boot"),
                "-XX:TieredStopAtLevel=1",
                "-Xmx128m"));
    command.addAll(options);
    command.addAll(List.of("-cp", Role.classPath(path), Role.class.getName()));
    command.addAll(List.of(role));
    process = new ProcessBuilder(command).redirectErrorStream(true).start();
    Thread reader = new Thread(this::read, "output of " + String.join(" ", role));
    reader.setDaemon(true);
    reader.start();
  }

  private void read() {
    try (BufferedReader in = process.inputReader()) {
      for (String line; (line = in.readLine()) != null; ) {
        output.append(line).append('\n');
        if (line.startsWith("said ")) {
          said.add(line.substring(5));
        }
      }
    } catch (IOException e) {
      output.append(e);
    } finally {
      said.add(ENDED);
    }
  }

  /** Its next line. */
  String awaitLine() throws InterruptedException {
    String line = said.poll(60, TimeUnit.SECONDS);
    if (line == null || line.equals(ENDED)) {
      throw new AssertionError("it said nothing within 60 s, or has ended: " + output);
    }
    return line;
  }

  /** Writes a line to its input and returns what it says then. */
  String ask(String line) throws IOException, InterruptedException {
    Writer to = process.outputWriter();
    to.write(line + "\n");
    to.flush();
    return awaitLine();
  }

  /** All it printed. */
  String output() {
    return output.toString();
  }

  @Override
  public void close() throws InterruptedException {
    process.destroyForcibly();
    process.waitFor(10, TimeUnit.SECONDS);
  }
}
