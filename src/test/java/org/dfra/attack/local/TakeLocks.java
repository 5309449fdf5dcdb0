package org.dfra.attack.local;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import org.dfra.benchmarks.attack.FileLocks;
import org.dfra.benchmarks.task.Task;

/**
 * Takes the locks of files and keeps them until its input ends.
 *
 * <p>For each file it prints {@code holds FILE} or {@code cannot FILE} with the reason.
 */
public final class TakeLocks implements Task {

  /**
   * Takes them.
   *
   * @param args the files
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    FileLocks locks = new FileLocks();
    for (String each : args) {
      try {
        out.println(
            locks.take(Path.of(each))
                ? "holds " + each
                : "cannot " + each + " another process holds it");
      } catch (IOException e) {
        out.println("cannot " + each + " " + e.getClass().getSimpleName());
      }
    }
    out.println("done");
    while (System.in.read() >= 0) {
      continue; // until its starter ends it
    }
    out.println("kept " + locks.count());
  }
}
