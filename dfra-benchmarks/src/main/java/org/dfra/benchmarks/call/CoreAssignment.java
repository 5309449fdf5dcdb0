package org.dfra.benchmarks.call;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Where the processes of a comparison run.
 *
 * @param client core of the client's process; -1 if the kernel chooses
 * @param server core of the server's process; -1 likewise
 * @param lowestPriority the command that starts a program with the lowest priority; with it, a busy
 *     loop keeps each of the cores from sleeping; empty for no such loop
 */
public record CoreAssignment(int client, int server, List<String> lowestPriority) {

  CoreAssignment(int client, int server) {
    this(client, server, List.of());
  }

  /** What pins the client's process; empty if the kernel chooses its core. */
  List<String> clientPrefix() {
    return pinning(client);
  }

  /** Likewise for the server's process. */
  List<String> serverPrefix() {
    return pinning(server);
  }

  /** What starts each busy loop; empty for none. */
  List<List<String>> busyPrefixes() {
    List<List<String>> prefixes = new ArrayList<>();
    if (!lowestPriority.isEmpty()) {
      for (int core : IntStream.of(client, server).distinct().toArray()) {
        List<String> prefix = new ArrayList<>(lowestPriority);
        prefix.addAll(pinning(core));
        prefixes.add(prefix);
      }
    }
    return prefixes;
  }

  private static List<String> pinning(int core) {
    return core < 0 ? List.of() : List.of("taskset", "-c", Integer.toString(core));
  }
}
