package org.dfra.testing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/**
 * Two hosts on one machine: network namespaces whose interfaces end in a switch, a third one, where
 * their connection can be cut and restored without notifying either of them. Each host has one real
 * interface, over which multicast goes, and a loopback of its own.
 *
 * <p>Creating them needs root on Linux; otherwise {@link #unavailableReason} returns the reason,
 * with which a test can skip itself.
 */
public final class NetworkNamespaceHosts implements AutoCloseable {

  /** Addresses of the two hosts; their network is not connected to any other. */
  public static final List<String> ADDRESSES = List.of("10.77.0.1", "10.77.0.2");

  private static final String BRIDGE = "br0";

  private static final String PREFIX = "dfra-";
  private static final String SEPARATOR = "n"; // not a digit in this radix
  private static final int RADIX = 20;
  private static final long PATIENCE_SECONDS = 10;
  private static final AtomicInteger COUNT = new AtomicInteger();

  private final List<String> made = new ArrayList<>();
  private final String tag;

  /**
   * Creates the two hosts and connects them.
   *
   * @throws IOException if the system refuses
   */
  public NetworkNamespaceHosts() throws IOException, InterruptedException {
    sweep();
    tag =
        Long.toString(ProcessHandle.current().pid(), RADIX)
            + SEPARATOR
            + Integer.toString(COUNT.incrementAndGet(), RADIX);
    try {
      make(theSwitch());
      inside(theSwitch(), "ip", "link", "add", BRIDGE, "type", "bridge", "mcast_snooping", "0");
      inside(theSwitch(), "ip", "link", "set", BRIDGE, "up");
      for (int host = 0; host < 2; host++) {
        make(name(host));
        run("ip", "link", "add", port(host, 'a'), "type", "veth", "peer", "name", port(host, 'b'));
        run("ip", "link", "set", port(host, 'a'), "netns", name(host));
        run("ip", "link", "set", port(host, 'b'), "netns", theSwitch());
        inside(theSwitch(), "ip", "link", "set", port(host, 'b'), "master", BRIDGE, "up");
        String own = port(host, 'a');
        inside(name(host), "ip", "addr", "add", ADDRESSES.get(host) + "/24", "dev", own);
        inside(name(host), "ip", "link", "set", "lo", "up");
        inside(name(host), "ip", "link", "set", own, "up");
        inside(name(host), "ip", "route", "add", "224.0.0.0/4", "dev", own);
      }
    } catch (IOException | InterruptedException e) {
      close();
      throw e;
    }
  }

  /** Why two hosts cannot be created here; empty if they can. */
  public static Optional<String> unavailableReason() throws InterruptedException {
    try {
      new NetworkNamespaceHosts().close();
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of("no network namespaces here: " + e.getMessage());
    }
  }

  /** Prefix of a command that is to run on a host, 0 or 1. */
  public List<String> commandPrefix(int host) {
    return List.of("ip", "netns", "exec", name(host));
  }

  /**
   * Cuts the connection: the switch drops everything, and both interfaces stay up. This simulates a
   * robot that drives out of radio range.
   */
  public void disconnect() throws IOException, InterruptedException {
    inside(theSwitch(), "bridge", "link", "set", "dev", port(0, 'b'), "state", "0");
  }

  /** Restores the connection. */
  public void reconnect() throws IOException, InterruptedException {
    inside(theSwitch(), "bridge", "link", "set", "dev", port(0, 'b'), "state", "3");
  }

  private void make(String namespace) throws IOException, InterruptedException {
    run("ip", "netns", "add", namespace);
    made.add(namespace);
  }

  private String theSwitch() {
    return PREFIX + tag + "-switch";
  }

  private String name(int host) {
    return PREFIX + tag + "-" + host;
  }

  /** An end of a host's cable: {@code a} at the host, {@code b} at the switch. */
  private String port(int host, char end) {
    return "df" + tag + host + end;
  }

  private static void inside(String namespace, String... command)
      throws IOException, InterruptedException {
    String unused =
        run(
            Stream.concat(Stream.of("ip", "netns", "exec", namespace), Stream.of(command))
                .toArray(String[]::new));
  }

  /** Removes the namespaces of killed tests. */
  private static void sweep() throws IOException, InterruptedException {
    for (String line : run("ip", "netns", "list").split("\n")) {
      String name = line.split(" ")[0];
      int end = name.indexOf(SEPARATOR, PREFIX.length());
      if (name.startsWith(PREFIX)
          && end > 0
          && ProcessHandle.of(Long.parseLong(name.substring(PREFIX.length(), end), RADIX))
              .isEmpty()) {
        remove(name);
      }
    }
  }

  private static void remove(String namespace) throws IOException, InterruptedException {
    List<ProcessHandle> left =
        run("ip", "netns", "pids", namespace)
            .lines()
            .flatMap(pid -> ProcessHandle.of(Long.parseLong(pid.strip())).stream())
            .toList();
    left.forEach(ProcessHandle::destroyForcibly);
    for (ProcessHandle process : left) {
      try {
        process.onExit().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
      } catch (ExecutionException | TimeoutException e) {
        throw new IOException("process " + process.pid() + " on a test's host does not end", e);
      }
    }
    run("ip", "netns", "delete", namespace);
  }

  private static String run(String... command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (process.waitFor() != 0) {
      throw new IOException(String.join(" ", command) + ": " + output.strip());
    }
    return output;
  }

  /** Kills the remaining processes on the hosts, with -9, and removes the hosts. Idempotent. */
  @Override
  public void close() throws IOException, InterruptedException {
    for (String namespace : List.copyOf(made)) {
      remove(namespace);
      made.remove(namespace);
    }
  }
}
