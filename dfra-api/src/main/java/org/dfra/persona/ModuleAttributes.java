package org.dfra.persona;

import java.time.Instant;
import java.util.Objects;
import org.dfra.lifecycle.Readiness;
import org.jspecify.annotations.Nullable;

/**
 * The attributes that every module publishes. Its server fills them in.
 *
 * @param robot name of the robot
 * @param name name of the module, unique on its robot
 * @param driver full name of the driver's class
 * @param host address or name of the machine it runs on, as in its proxies
 * @param author author of the driver
 * @param version version of the driver
 * @param state lifecycle state of the module
 * @param created when the module was first registered with its robot, UTC
 * @param activated when it was last started, UTC; null if it never was
 * @param clients how many clients hold a lease on it
 */
public record ModuleAttributes(
    String robot,
    String name,
    String driver,
    String host,
    String author,
    String version,
    Readiness state,
    Instant created,
    @Nullable Instant activated,
    int clients)
    implements Attributes {

  public ModuleAttributes {
    AttributeValidation.requireText("robot", robot);
    AttributeValidation.requireText("name", name);
    Objects.requireNonNull(driver, "driver"); // foreign entries may omit any of these
    Objects.requireNonNull(host, "host");
    Objects.requireNonNull(author, "author");
    Objects.requireNonNull(version, "version");
    Objects.requireNonNull(state, "state");
    created = Objects.requireNonNull(AttributeValidation.truncatedToMillis(created));
    activated = AttributeValidation.truncatedToMillis(activated);
    if (clients < 0) {
      throw new IllegalArgumentException(clients + " clients are fewer than none");
    }
  }

  /** {@code robot/name}. */
  public String path() {
    return robot + "/" + name;
  }
}
