package org.dfra.app;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dfra.cli.Main;
import org.dfra.testing.EmbeddedReggie;
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

  /**
   * The same, of a command that looks for modules: it finds those of one lookup service, and waits
   * 20 s for them where its words do not say how long.
   *
   * @param state a folder that nobody's phoenix uses; it need not be there
   * @param words the command and its options
   */
  public static InProcessCommand at(EmbeddedReggie reggie, Path state, List<String> words) {
    List<String> all = new ArrayList<>(words);
    if (words.stream().noneMatch(each -> each.startsWith("--wait="))) {
      all.add("--wait=20");
    }
    all.addAll(
        List.of(
            "--team=",
            "--locator=" + EmbeddedReggie.HOST + ":" + reggie.port(),
            "--host=" + EmbeddedReggie.HOST,
            "--state=" + state));
    return run(all.toArray(String[]::new));
  }
}
