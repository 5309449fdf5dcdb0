package org.dfra.attack.kit;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.TreeMap;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.lookup.entry.Name;
import org.dfra.benchmarks.attack.SourceBoundProxies;
import org.dfra.benchmarks.attack.SourceSockets;
import org.dfra.benchmarks.task.Task;
import org.dfra.flow.effector.DriveEffector;
import org.jspecify.annotations.Nullable;

/**
 * Registers fakes in a robot's registrar, from any address of this computer, as a process of its
 * own. A line of its input is an address and a verb; each is answered by a line with its outcome:
 * {@code done}, or the exception.
 *
 * <p>{@code learn} keeps the service ID of the drive; {@code steal} registers a fake under it, and
 * {@code claim ROBOT} one under its own that names the robot. {@code many N} registers so many of
 * other robots, and is answered by how many had each outcome.
 */
public final class FakeServices implements Task {

  private static final String DONE = "done";

  private @Nullable ServiceID drive;

  /** As every task is made. */
  public FakeServices() {}

  private interface Registration {
    void run() throws Exception;
  }

  /** Arguments: the registrar's host and port. */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    out.println("ready");
    BufferedReader in =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line; (line = in.readLine()) != null; ) {
      String[] words = line.split(" ");
      ServiceRegistrar registrar =
          SourceBoundProxies.registrar(
              args[0], Integer.parseInt(args[1]), SourceSockets.from(words[0]));
      String outcome =
          switch (words[1]) {
            case "learn" -> outcome(() -> drive = Fakes.id(registrar, DriveEffector.class));
            case "steal" -> outcome(() -> register(registrar, drive, "drive", new Name("drive")));
            case "claim" ->
                outcome(() -> register(registrar, null, "own", Fakes.module(words[2], "drive")));
            case "many" -> many(registrar, Integer.parseInt(words[2]));
            default -> throw new IllegalArgumentException(line);
          };
      out.println(outcome);
    }
  }

  private static void register(
      ServiceRegistrar registrar, @Nullable ServiceID id, String proxy, Entry entry)
      throws Exception {
    Object unused = Fakes.register(registrar, id, "a fake: " + proxy, entry);
  }

  private static String many(ServiceRegistrar registrar, int count) {
    Map<String, Integer> outcomes = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      String name = "fake" + i;
      String outcome = outcome(() -> register(registrar, null, name, Fakes.module(name, "drive")));
      outcomes.merge(outcome, 1, Integer::sum);
    }
    return outcomes.toString();
  }

  private static String outcome(Registration registration) {
    try {
      registration.run();
      return DONE;
    } catch (Exception e) { // whatever stops it is its outcome
      return e.getClass().getSimpleName();
    }
  }
}
