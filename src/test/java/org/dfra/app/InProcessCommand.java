package org.dfra.app;

import java.io.PrintWriter;
import java.io.StringWriter;
import picocli.CommandLine;

/**
 * What a command came to that ran in the test's own virtual machine, as {@code ./dfra} runs it.
 *
 * @param code its exit code
 * @param out what it wrote to its output
 * @param err what it wrote to its standard error
 */
public record InProcessCommand(int code, String out, String err) {

  /** Runs {@code ./dfra} with these arguments, to its end. */
  public static InProcessCommand run(String... args) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    CommandLine line = Main.commandLine(args);
    line.setOut(new PrintWriter(out, true));
    line.setErr(new PrintWriter(err, true));
    int code = line.execute(args);
    return new InProcessCommand(code, out.toString(), err.toString());
  }
}
