package org.dfra.app.bench.attack;

import java.io.IOException;
import java.io.PrintStream;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import net.jini.core.lookup.ServiceItem;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.jspecify.annotations.Nullable;

/**
 * An attack that is repeated until its input has a line or ends. It prints {@code begins}, and at
 * the end {@code done CALLS REFUSED REASON}, the reason being that of the last refusal.
 *
 * <p>Its arguments are those of {@link Target#arguments}. One thread attacks; another reads the
 * input.
 */
public abstract class AttackTask implements Task {

  /**
   * A robot and where it is attacked from.
   *
   * @param source the attacker's address
   * @param host the robot's address
   * @param registrarPort port of its registrar for unicast discovery
   * @param classPort port of its class server
   */
  public record Target(String source, String host, int registrarPort, int classPort) {

    /** Arguments of the attack's process. */
    public String[] arguments() {
      return new String[] {
        source, host, Integer.toString(registrarPort), Integer.toString(classPort)
      };
    }

    static Target parse(String[] arguments) {
      return new Target(
          arguments[0],
          arguments[1],
          Integer.parseInt(arguments[2]),
          Integer.parseInt(arguments[3]));
    }

    SourceSockets sockets() {
      return SourceSockets.from(source);
    }

    /** The robot's registrar, called from the attacker's address. */
    ServiceRegistrar registrar() throws IOException {
      return Rebased.registrar(host, registrarPort, sockets());
    }

    /** How the registrar holds the robot's drive. */
    ServiceItem drive() throws IOException {
      Class<?>[] types = {DriveEffector.class};
      ServiceItem[] found = registrar().lookup(new ServiceTemplate(null, types, null), 1).items;
      if (found.length == 0 || found[0].service == null) {
        throw new IOException("the registrar at " + host + ":" + registrarPort + " has no drive");
      }
      return found[0];
    }

    /** The drive's remote proxy, called from the attacker's address. */
    RemoteDriveEffector remoteDrive() throws IOException {
      return Rebased.of(Rebased.remote(drive().service, RemoteDriveEffector.class), sockets());
    }
  }

  private volatile boolean stopping;
  private long calls; // by the attacking thread, as the others
  private long refused;
  private @Nullable Exception refusal;

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
    while (!stopping) {
      attack(target);
    }
    out.println("done " + calls + " " + refused + " " + refusal);
  }

  private void awaitStop() {
    try {
      int unused = System.in.read();
    } catch (IOException e) {
      e.printStackTrace(); // then it ends too
    }
    stopping = true;
  }

  /**
   * Finds what is needed.
   *
   * @throws Exception if the robot is not found
   */
  protected void prepare(Target target) throws Exception {}

  /**
   * Does it once.
   *
   * @throws Exception if the attack itself fails; {@link #attempt} counts what the robot refuses
   */
  protected abstract void attack(Target target) throws Exception;

  /** Whether the attack is to end. */
  protected final boolean isStopping() {
    return stopping;
  }

  /** Makes a call, and counts it, and whether it was refused. */
  protected final <R> @Nullable R attempt(Callable<R> call) {
    calls++;
    try {
      return call.call();
    } catch (Exception e) { // of whatever kind: kept, and printed at the end
      refused++;
      refusal = e;
      return null;
    }
  }

  /** Waits, between two attempts. */
  protected static void pause(long millis) {
    LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(millis));
  }
}
