package org.dfra.benchmarks.attack;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.benchmarks.task.Task;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.report.measurement.MeasuredValue;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.jspecify.annotations.Nullable;

/**
 * An attack that is repeated until standard input has a line or ends, and executed at least once.
 * It prints {@code begins}, {@code refused REASON} at the robot's first refusal, and at the end its
 * {@linkplain MeasuredValueLines own measurements} and {@code done CALLS REFUSED REASON} with the
 * reason of the last refusal.
 *
 * <p>Its arguments are those of {@link Target#arguments}. One thread attacks; another reads the
 * input.
 */
public abstract class AttackTask implements Task {

  /**
   * A robot and the address from which it is attacked.
   *
   * @param source the attacker's address
   * @param host the robot's address
   * @param registrarPort port of its registrar for unicast discovery
   * @param classPort port of its class server
   * @param phoenixPort port of its phoenix; 0 if it has none
   * @param groupLock the lock file of one of phoenix's groups; empty if there is none
   * @param folder an empty folder that the attacker may write to; empty if it needs none
   */
  public record Target(
      String source,
      String host,
      int registrarPort,
      int classPort,
      int phoenixPort,
      Path groupLock,
      Path folder) {

    private static final Path NONE = Path.of("");

    /** A robot without phoenix, and an attack that writes nothing. */
    public Target(String source, String host, int registrarPort, int classPort) {
      this(source, host, registrarPort, classPort, 0, NONE, NONE);
    }

    /** Arguments of the attack's process. */
    public String[] arguments() {
      return new String[] {
        source,
        host,
        Integer.toString(registrarPort),
        Integer.toString(classPort),
        Integer.toString(phoenixPort),
        groupLock.toString(),
        folder.toString()
      };
    }

    static Target parse(String[] arguments) {
      return new Target(
          arguments[0],
          arguments[1],
          Integer.parseInt(arguments[2]),
          Integer.parseInt(arguments[3]),
          Integer.parseInt(arguments[4]),
          Path.of(arguments[5]),
          Path.of(arguments[6]));
    }

    SourceSockets sockets() {
      return SourceSockets.from(source);
    }

    /** The robot's registrar, called from the attacker's address. */
    ServiceRegistrar registrar() throws IOException {
      return SourceBoundProxies.registrar(host, registrarPort, sockets());
    }

    /** The registrar's service item of the robot's drive. */
    ServiceItem drive() throws IOException {
      Class<?>[] types = {DriveEffector.class};
      ModuleEntry robots = new ModuleEntry();
      robots.robot = HonestRobot.NAME; // and not a fake of another robot
      ServiceTemplate honest = new ServiceTemplate(null, types, new Entry[] {robots});
      ServiceItem[] found = registrar().lookup(honest, 1).items;
      if (found.length == 0 || found[0].service == null) {
        throw new IOException("the registrar at " + host + ":" + registrarPort + " has no drive");
      }
      return found[0];
    }

    /** The drive's remote proxy, called from the attacker's address. */
    RemoteDriveEffector remoteDrive() throws IOException {
      return SourceBoundProxies.of(
          SourceBoundProxies.remote(drive().service, RemoteDriveEffector.class), sockets());
    }
  }

  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private volatile boolean stopping;
  private long calls; // used by the attacking thread only, like the others
  private long refused;
  private @Nullable Exception refusal;
  private @Nullable PrintStream lines; // from the start of the attack

  /** For subclasses. */
  protected AttackTask() {}

  @Override
  public final void run(String[] args, PrintStream out) throws Exception {
    Thread input = new Thread(this::awaitStop, "awaits the end of the attack");
    input.setDaemon(true);
    input.start();
    Target target = Target.parse(args);
    prepare(target);
    out.println("begins");
    lines = out;
    do {
      attack(target);
    } while (!stopping);
    end(target);
    figures().stream().map(MeasuredValueLines::write).forEach(out::println);
    out.println("done " + calls + " " + refused + " " + refusal);
  }

  private void awaitStop() {
    try {
      int unused = System.in.read();
    } catch (IOException e) {
      e.printStackTrace(); // at end of input the attack ends too
    }
    stopping = true;
  }

  /**
   * Looks up the objects that the attack needs.
   *
   * @throws Exception if the robot is not found
   */
  protected void prepare(Target target) throws Exception {}

  /**
   * Executes the attack once.
   *
   * @throws Exception if the attack itself fails; {@link #attempt} counts the robot's refusals
   */
  protected abstract void attack(Target target) throws Exception;

  /**
   * Finishes the attack, after the robot's wheels were measured.
   *
   * @throws Exception if the attack did not reach the robot
   */
  protected void end(Target target) throws Exception {}

  /** Its own measurements at the end. */
  protected List<MeasuredValue> figures() {
    return List.of();
  }

  /** Whether the attack is to end. */
  protected final boolean isStopping() {
    return stopping;
  }

  /** Makes a call, counts it, and counts a refusal. */
  protected final <R> @Nullable R attempt(Callable<R> call) {
    calls++;
    try {
      return call.call();
    } catch (Exception e) { // of any type: kept, and printed at the end
      refusedBy(e);
      return null;
    }
  }

  /**
   * Counts a refused call that {@link #attempt} did not make.
   *
   * @param what the refused call
   */
  protected final void countRefused(String what) {
    calls++;
    refusedBy(new IOException("refused: " + what));
  }

  private void refusedBy(Exception reason) {
    refusal = reason;
    if (refused++ == 0 && lines != null) {
      lines.println("refused " + reason);
    }
  }

  /**
   * Sends a hand-written request.
   *
   * @param proxy of the called object
   * @throws RemoteException if it was refused or not answered
   * @throws IOException if it cannot be sent
   */
  protected static RawCall.Answer send(Object proxy, byte[] request)
      throws IOException, InterruptedException {
    try (RawCall call = RawCall.to(proxy)) {
      RawCall.Answer answer = call.send(request).finish(PATIENCE);
      if (answer.status() == RawCall.Status.THREW) {
        throw new RemoteException("refused: " + answer.object());
      }
      if (answer.status() != RawCall.Status.RETURNED) {
        throw new RemoteException("not answered: " + answer.status(), answer.failure());
      }
      return answer;
    }
  }

  /** Waits, between two attempts. */
  protected static void pause(long millis) {
    LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(millis));
  }
}
