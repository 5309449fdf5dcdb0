package org.dfra.core.time;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.core.config.ConfigurationException;

/**
 * The time that this virtual machine's robot lives by. It is told by the system property {@value
 * #PROPERTY}, or where that is not set by the environment's {@value #VARIABLE}, which {@code ./dfra
 * up} hands on to every group: a {@link ScaledTime} as it writes itself, or {@value #REAL}.
 */
public final class RobotTime {

  /** The system property. */
  public static final String PROPERTY = "dfra.time";

  /** The environment's variable. */
  public static final String VARIABLE = "DFRA_TIME";

  /** How real time is written. */
  public static final String REAL = "real";

  /** By how it is written: modules that share a device must share the time they wait by. */
  private static final ConcurrentHashMap<String, ScaledTime> KNOWN = new ConcurrentHashMap<>();

  private RobotTime() {}

  /**
   * The clock of the robot's modules: one for all of this virtual machine.
   *
   * @throws ConfigurationException if what is set is no time; the message says what would be
   */
  public static InstantSource clock() {
    Optional<String> set = set();
    if (set.isEmpty()) {
      return InstantSource.system();
    }
    try {
      return KNOWN.computeIfAbsent(set.get(), ScaledTime::parse);
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(
          VARIABLE + " (or -D" + PROPERTY + "): " + e.getMessage() + ", or write real", e);
    }
  }

  /** What another virtual machine must be started with to live by the same time. */
  public static List<String> options() {
    return set().map(time -> List.of("-D" + PROPERTY + "=" + time)).orElse(List.of());
  }

  private static Optional<String> set() {
    String property = System.getProperty(PROPERTY);
    String text = property == null ? System.getenv(VARIABLE) : property;
    return Optional.ofNullable(text).filter(time -> !time.isBlank() && !time.equals(REAL));
  }
}
