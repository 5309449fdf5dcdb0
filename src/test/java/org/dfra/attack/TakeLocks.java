package org.dfra.attack;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import org.dfra.app.bench.attack.Task;

/**
 * Takes the locks of files and keeps them until its input ends. A lock for reading needs no right
 * but to read, and keeps everybody else from a lock for writing.
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
    List<FileLock> taken = new ArrayList<>();
    for (String each : args) {
      try {
        FileChannel channel = FileChannel.open(Path.of(each), StandardOpenOption.READ);
        FileLock lock = channel.tryLock(0, Long.MAX_VALUE, true);
        if (lock == null) {
          out.println("cannot " + each + " another process holds it");
        } else {
          taken.add(lock);
          out.println("holds " + each);
        }
      } catch (IOException e) {
        out.println("cannot " + each + " " + e.getClass().getSimpleName());
      }
    }
    out.println("done");
    while (System.in.read() >= 0) {
      continue; // until its starter ends it
    }
    out.println("kept " + taken.size());
  }
}
