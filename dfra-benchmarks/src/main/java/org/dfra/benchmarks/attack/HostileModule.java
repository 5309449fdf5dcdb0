package org.dfra.benchmarks.attack;

import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import net.jini.admin.Administrable;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.effector.EmergencyStopState;
import org.dfra.geometry.Transform;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Identification;
import org.dfra.module.LogLevel;
import org.dfra.module.ModuleHistory;
import org.dfra.module.Parameter;
import org.dfra.module.Precondition;
import org.dfra.persona.Attributes;
import org.dfra.persona.EmergencyStopAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.remote.ModuleAdmin;
import org.jspecify.annotations.Nullable;

/**
 * An attacker's drive: it answers every call with text that contains terminal control characters or
 * starts a line with {@link #FORGED}. Where no text can be returned it throws an exception with
 * this message.
 */
public final class HostileModule implements InvocationHandler, Serializable {

  private static final long serialVersionUID = 1L;

  /** A text that an operator must not see at the start of a line. */
  public static final String FORGED = "2 effectors: 2 stopped.";

  /** Clears the screen, writes the clipboard, reverses the text direction, starts new lines. */
  public static final String TEXT =
      "x\u001b[2J\u001b]52;c;eA==\u0007\u009b2J\u202e\u2028\r"
          + FORGED
          + "\n"
          + FORGED
          + " ".repeat(100)
          + FORGED;

  /** The text as a name; its first line needs no control character. */
  public static final String NAME = FORGED + "\u009b2K\n" + FORGED;

  private HostileModule() {}

  /** Its proxy. */
  public static DriveEffector proxy() {
    return (DriveEffector) proxy(DriveEffector.class, Administrable.class);
  }

  private static Object proxy(Class<?>... interfaces) {
    return Proxy.newProxyInstance(
        HostileModule.class.getClassLoader(), interfaces, new HostileModule());
  }

  /** The attributes that it registers with. */
  public static List<Attributes> attributes() {
    return List.of(
        new ModuleAttributes(
            NAME,
            NAME,
            TEXT,
            "127.0.0.1", // a name would be looked up
            TEXT,
            TEXT,
            Readiness.FAILED,
            Instant.EPOCH,
            null,
            1),
        new EmergencyStopAttributes(true, TEXT, Instant.EPOCH));
  }

  /**
   * The attributes of a drive in emergency stop, whose texts are harmless except the requester's
   * name.
   *
   * @param robot its robot
   * @param by the requester of the stop in its attributes
   */
  public static List<Attributes> stopped(String robot, String by) {
    return List.of(
        new ModuleAttributes(
            robot,
            "drive",
            "org.example.Fake",
            "127.0.0.1",
            "",
            "1",
            Readiness.READY,
            Instant.EPOCH,
            null,
            0),
        new EmergencyStopAttributes(true, by, Instant.EPOCH));
  }

  /** The attributes of its robot. */
  public static PersonaAttributes persona() {
    return new PersonaAttributes(NAME, TEXT, List.of(TEXT), List.of(TEXT));
  }

  @Override
  public Object invoke(Object self, Method method, Object @Nullable [] arguments)
      throws RemoteException {
    return switch (method.getName()) {
      case "hashCode" -> 1;
      case "equals" -> arguments != null && self == arguments[0];
      case "toString", "frame", "parentFrame", "unreadiness" -> TEXT;
      case "identification" -> new Identification(NAME, NAME, TEXT, TEXT, TEXT);
      case "readiness", "awaitReadiness" -> Readiness.FAILED;
      case "logLevel" -> LogLevel.INFO;
      case "history" ->
          new ModuleHistory(
              Instant.EPOCH,
              1,
              1,
              1,
              Duration.ZERO,
              List.of(new Incident(Instant.EPOCH, Incident.Kind.FAILURE, TEXT)));
      case "parameters" -> List.of(new Parameter(TEXT, TEXT, TEXT, true));
      case "preconditions" -> List.of(new Precondition(TEXT, 0, 1, TEXT));
      case "tests", "recoveries", "inputTypes", "outputTypes", "inputs", "outputs" -> List.of(TEXT);
      case "localTransform" -> Transform.IDENTITY;
      case "emergencyStop", "releaseEmergencyStop", "emergencyStopState" ->
          new EmergencyStopState(true, TEXT, Instant.EPOCH, false, TEXT, Duration.ofHours(1));
      case "getAdmin" -> proxy(ModuleAdmin.class);
      case "hostTime" -> Instant.now();
      case "heldLeases" -> Set.of();
      case "leases" ->
          List.of(
              new LeaseStatus(
                  new LeaseHandle(UUID.randomUUID()),
                  LeaseRole.COMMANDER,
                  TEXT,
                  Instant.EPOCH,
                  Duration.ofSeconds(1),
                  Duration.ofSeconds(5)));
      default -> throw new RemoteException(TEXT);
    };
  }
}
