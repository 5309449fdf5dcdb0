package org.dfra.benchmarks.scale;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.util.List;
import org.dfra.benchmarks.task.Task;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;

/**
 * The process of somebody who looks at a team. It prints {@code ready}, and executes the commands
 * of {@link TeamView}. It ends with its input.
 */
public final class ObserverTask implements Task {

  /** For {@link org.dfra.benchmarks.task.TaskProcess}. */
  public ObserverTask() {}

  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    try (TeamView view =
            new TeamView(List.of(Thread.currentThread().getContextClassLoader()), out);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in))) {
      out.println("ready");
      for (String line; (line = in.readLine()) != null; ) {
        view.execute(line);
      }
    }
    System.exit(0);
  }
}
