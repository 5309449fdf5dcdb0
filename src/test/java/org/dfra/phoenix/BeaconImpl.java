package org.dfra.phoenix;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.rmi.MarshalledObject;
import java.rmi.Remote;
import java.rmi.activation.ActivationGroup;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import net.jini.export.Exporter;
import net.jini.export.ProxyAccessor;
import net.jini.jeri.BasicJeriExporter;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.ResurrectingExporter;
import org.dfra.river.phoenix.ReadinessSource;

/**
 * A beacon under phoenix. Its data is a text, {@code mode device}:
 *
 * <ul>
 *   <li>mode {@code ok}; {@code throws} or {@code halts} in the constructor; {@code slow} in it,
 *       until there is a file {@code device.go}; {@code river} uses River's own exporter; {@code
 *       brief} is ready for 0.2 s, and halts 1.5 s after it was made; {@code steady} only halts so
 *   <li>device: a file that one process at a time can own, as a serial port is. A second owner
 *       writes {@code CONFLICT} into {@code device.log}: the ground truth for "never two of one
 *       group", whatever phoenix believes.
 * </ul>
 */
public class BeaconImpl implements Beacon, ProxyAccessor, ReadinessSource {

  private static final AtomicInteger INSTANCES = new AtomicInteger();
  private static final Map<String, FileChannel> DEVICES = new ConcurrentHashMap<>();

  private static final Duration BRIEF = Duration.ofMillis(200);
  private static final Duration LIFE = Duration.ofMillis(1500);

  private final long made = System.nanoTime();
  private final boolean isBrief;
  private final ActivationID id;
  private final Exporter exporter;
  private final Remote proxy;
  private final AtomicInteger counter = new AtomicInteger();

  /** Called by the group; it may be package-private. */
  BeaconImpl(ActivationID id, MarshalledObject<String> data) throws Exception {
    this.id = id;
    String[] words = data == null ? new String[] {"ok"} : data.get().split(" ", 2);
    isBrief = words[0].equals("brief");
    if (words.length > 1) {
      DEVICES.computeIfAbsent(words[1], BeaconImpl::own);
    }
    switch (words[0]) {
      case "throws" -> throw new IllegalStateException("the receiver is not plugged in");
      case "halts" -> Runtime.getRuntime().halt(77);
      case "brief", "steady" ->
          CompletableFuture.delayedExecutor(LIFE.toMillis(), TimeUnit.MILLISECONDS)
              .execute(() -> Runtime.getRuntime().halt(77));
      case "slow" -> awaitFile(Path.of(words[1] + ".go"));
      default -> {}
    }
    Exporter live =
        new BasicJeriExporter(
            Endpoints.tcp("127.0.0.1", 0), new DeadlineILFactory(2000L), false, true);
    exporter =
        words[0].equals("river")
            ? new net.jini.activation.ActivationExporter(id, live)
            : new ResurrectingExporter(id, live);
    proxy = exporter.export(this);
    INSTANCES.incrementAndGet();
  }

  private static void awaitFile(Path file) {
    await().atMost(PhoenixFixture.PATIENCE).until(() -> Files.exists(file));
  }

  private static FileChannel own(String device) {
    Path log = Path.of(device + ".log");
    long pid = ProcessHandle.current().pid();
    try {
      FileChannel channel =
          FileChannel.open(Path.of(device), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
      String line = (channel.tryLock() != null ? "opened by " : "CONFLICT seen by ") + pid + "\n";
      Files.writeString(log, line, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      return channel;
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @Override
  public boolean isReady() {
    return !isBrief || System.nanoTime() - made < BRIEF.toNanos();
  }

  @Override
  public Object getProxy() {
    return proxy;
  }

  @Override
  public long pid() {
    return ProcessHandle.current().pid();
  }

  @Override
  public int instances() {
    return INSTANCES.get();
  }

  @Override
  public int count() {
    return counter.incrementAndGet();
  }

  @Override
  public void sleep(long millis) {
    try {
      new CountDownLatch(1).await(millis, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public int length(byte[] load) {
    return load.length;
  }

  @Override
  public void deactivate() {
    new Thread(
            () -> {
              try {
                while (!net.jini.activation.ActivationGroup.inactive(id, exporter)) {
                  Thread.onSpinWait(); // the call that asked for it is still on its way back
                }
              } catch (Exception e) {
                e.printStackTrace();
              }
            })
        .start();
  }

  @Override
  public void print(String line) {
    System.out.println(line);
  }

  /** No constructor for a group. */
  public static class WithoutConstructor implements Remote {}

  /** Nothing that can be called from elsewhere. */
  public static class NotRemote {
    /** Called by the group. */
    public NotRemote(ActivationID id, MarshalledObject<String> data) {
      assert ActivationGroup.currentGroupID() != null;
    }
  }
}
