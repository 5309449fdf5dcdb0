package org.dfra.core.time;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.dfra.core.config.ConfigurationException;

/**
 * The clock of this virtual machine's robot. It is set by the system property {@value #PROPERTY},
 * or else by the environment variable {@value #VARIABLE}, which {@code ./dfra up} passes to every
 * group: the text of a {@link ScaledTime}, or {@value #REAL}.
 */
public final class RobotTime {

  /** The system property. */
  public static final String PROPERTY = "dfra.time";

  /** The environment variable. */
  public static final String VARIABLE = "DFRA_TIME";

  /** The value for real time. */
  public static final String REAL = "real";

  /** Clocks by their text: modules that share a device must share a clock. */
  private static final ConcurrentHashMap<String, ScaledTime> KNOWN = new ConcurrentHashMap<>();

  private RobotTime() {}

  /**
   * The clock of the robot's modules: one for all of this virtual machine.
   *
   * @throws ConfigurationException if the value is invalid; the message names valid values
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

  /** The JVM options that make another virtual machine use the same clock. */
  public static List<String> options() {
    return set().map(time -> List.of("-D" + PROPERTY + "=" + time)).orElse(List.of());
  }

  private static Optional<String> set() {
    String property = System.getProperty(PROPERTY);
    String text = property == null ? System.getenv(VARIABLE) : property;
    return Optional.ofNullable(text).filter(time -> !time.isBlank() && !time.equals(REAL));
  }
}
