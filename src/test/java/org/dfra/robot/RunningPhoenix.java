package org.dfra.robot;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.core.host.FreePorts;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.GroupStatus;

/** A phoenix for tests: its process and those of its groups are ended by number, come what may. */
public final class RunningPhoenix implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private final PhoenixProcess phoenix;
  private final ProcessHandle process;
  private final Set<ProcessHandle> seen = ConcurrentHashMap.newKeySet();
  private final Thread lastResort = new Thread(this::killAll, "phoenix of a test ends");

  private RunningPhoenix(PhoenixProcess phoenix, ProcessHandle process) {
    this.phoenix = phoenix;
    this.process = process;
    seen.add(process);
    Runtime.getRuntime().addShutdownHook(lastResort);
  }

  public static RunningPhoenix start(Path state) throws IOException {
    return start("127.0.0.1", state);
  }

  public static RunningPhoenix start(String host, Path state) throws IOException {
    PhoenixProcess phoenix = new PhoenixProcess(host, FreePorts.allocate(), -1, state);
    return new RunningPhoenix(phoenix, phoenix.start(PATIENCE).toHandle());
  }

  public PhoenixProcess process() {
    return phoenix;
  }

  /** What phoenix says of the group {@code robot.group}. */
  public GroupStatus group(String name) throws IOException {
    note();
    return phoenix.admin().groupStatus().stream()
        .filter(group -> group.name().endsWith(name))
        .findFirst()
        .orElseThrow(() -> new IOException("phoenix knows no group " + name));
  }

  /** Kills a group's process with -9 and waits until it is gone. */
  public void kill(String group) throws IOException {
    ProcessHandle victim = ProcessHandle.of(group(group).pid()).orElseThrow();
    victim.destroyForcibly();
    await().atMost(PATIENCE).until(() -> !victim.isAlive());
  }

  /** Remembers every process that belongs to it now. */
  public void note() {
    process.descendants().forEach(seen::add);
  }

  @Override
  public void close() throws IOException {
    note();
    try {
      phoenix.shutdown(PATIENCE);
      await().atMost(PATIENCE).until(() -> seen.stream().noneMatch(ProcessHandle::isAlive));
    } finally {
      killAll();
      Runtime.getRuntime().removeShutdownHook(lastResort);
    }
  }

  private void killAll() {
    note();
    seen.forEach(ProcessHandle::destroyForcibly);
  }
}
