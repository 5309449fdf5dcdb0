package org.dfra.testing;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * A process with which a test communicates line by line: the test writes a line to its input, and
 * the process replies with a line that begins with {@value #RESPONSE_PREFIX}. All other output is
 * its log.
 */
public final class InteractiveProcess implements AutoCloseable {

  /** Prefix of a line that is a response to the test. */
  public static final String RESPONSE_PREFIX = "said ";

  private static final String ENDED = "";
  private static final long TIMEOUT_SECONDS = 60;

  private final Process process;
  private final LinkedBlockingQueue<String> responses = new LinkedBlockingQueue<>();
  private final StringBuffer output = new StringBuffer();

  /**
   * Starts the process.
   *
   * @param command its program and arguments
   */
  public InteractiveProcess(List<String> command) throws IOException {
    process = new ProcessBuilder(command).redirectErrorStream(true).start();
    Thread reader = new Thread(this::read, "output of process " + process.pid());
    reader.setDaemon(true);
    reader.start();
  }

  /**
   * Program and arguments of a small JVM on this one's Java, up to the main class.
   *
   * @param classPath the class path
   * @param options options of the JVM, besides the boot class path, which is this one's ({@code
   *     dfra.boot-class-path})
   */
  public static List<String> java(String classPath, List<String> options) {
    List<String> command =
        new ArrayList<>(
            List.of(
                System.getProperty("java.home") + "/bin/java",
                "-Xbootclasspath/a:" + System.getProperty("dfra.boot-class-path"),
                "-XX:TieredStopAtLevel=1",
                "-XX:CompileThresholdScaling=3",
                "-XX:+UseSerialGC",
                "-Xmx128m"));
    command.addAll(options);
    command.addAll(List.of("-cp", classPath));
    return command;
  }

  private void read() {
    try (BufferedReader in = process.inputReader()) {
      for (String line; (line = in.readLine()) != null; ) {
        output.append(line).append('\n');
        if (line.startsWith(RESPONSE_PREFIX)) {
          responses.add(line.substring(RESPONSE_PREFIX.length()));
        }
      }
    } catch (IOException e) {
      output.append(e);
    } finally {
      responses.add(ENDED);
    }
  }

  /**
   * Its next line, without {@value #RESPONSE_PREFIX}.
   *
   * @throws AssertionError if none comes within 60 s, or the process has ended
   */
  public String awaitLine() throws InterruptedException {
    String line = responses.poll(TIMEOUT_SECONDS, TimeUnit.SECONDS);
    if (line == null || line.equals(ENDED)) {
      throw new AssertionError(
          "it said nothing within " + TIMEOUT_SECONDS + " s, or has ended: " + output);
    }
    return line;
  }

  /** Writes a line to its input and returns the response. */
  public String request(String line) throws IOException, InterruptedException {
    Writer to = process.outputWriter();
    to.write(line + "\n");
    to.flush();
    return awaitLine();
  }

  /** All its output. */
  public String output() {
    return output.toString();
  }

  /** Its process ID. */
  public long pid() {
    return process.pid();
  }

  @Override
  public void close() throws InterruptedException {
    process.destroyForcibly();
    process.waitFor(10, TimeUnit.SECONDS);
  }
}
