package org.dfra.river.lookup;

import java.util.Map;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.NoSuchEntryException;
import org.jspecify.annotations.Nullable;

/** A Jini configuration with robot timings for what it does not say itself. */
final class Defaults implements Configuration {

  /** By {@code component.entry}; milliseconds. */
  private static final Map<String, Object> ROBOT =
      Map.of(
          "net.jini.lookup.JoinManager.maxLeaseDuration", 30_000L,
          "net.jini.lease.LeaseRenewalManager.roundTripTime", 2_000L);

  private final Configuration said;

  Defaults(Configuration said) {
    this.said = said;
  }

  private static @Nullable Object standard(String component, String name) {
    return ROBOT.get(component + "." + name);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Object getEntry(String component, String name, Class type) throws ConfigurationException {
    return getEntry(component, name, type, NO_DEFAULT, NO_DATA);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Object getEntry(String component, String name, Class type, @Nullable Object defaultValue)
      throws ConfigurationException {
    return getEntry(component, name, type, defaultValue, NO_DATA);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  public Object getEntry(
      String component, String name, Class type, @Nullable Object defaultValue, Object data)
      throws ConfigurationException {
    @Nullable Object standard = standard(component, name);
    if (standard == null) {
      return said.getEntry(component, name, type, defaultValue, data);
    }
    try {
      return said.getEntry(component, name, type, NO_DEFAULT, data);
    } catch (NoSuchEntryException e) {
      return standard;
    }
  }
}
