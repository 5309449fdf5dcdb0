package org.dfra.river.phoenix;

import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationInstantiator;
import java.time.Duration;
import java.util.List;
import javax.security.auth.login.LoginContext;
import net.jini.config.Configuration;
import net.jini.config.ConfigurationException;
import net.jini.config.NoSuchEntryException;
import net.jini.export.Exporter;
import net.jini.id.Uuid;
import net.jini.security.BasicProxyPreparer;
import net.jini.security.ProxyPreparer;
import org.dfra.core.config.RenamedNames;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.call.JeriExporters;
import org.dfra.river.phoenix.restart.RestartPolicy;
import org.dfra.river.phoenix.stop.StopLocator;
import org.jspecify.annotations.Nullable;

/**
 * Phoenix's Jini configuration: the entries of component {@value #COMPONENT}.
 *
 * <p>Names are those of the original phoenix if it has them. {@code docs/reference/phoenix.md}
 * lists every entry.
 */
record PhoenixConfiguration(
    Path persistenceDirectory,
    Path outputDirectory,
    int persistenceSnapshotThreshold,
    @Nullable LoginContext loginContext,
    Exporter activatorExporter,
    Exporter systemExporter,
    Exporter monitorExporter,
    Exporter stopExporter,
    ProxyPreparer instantiatorPreparer,
    String @Nullable [] groupConfig,
    @Nullable String groupLocation,
    List<String> groupOptions,
    Duration groupTimeout,
    int groupThrottle,
    Duration unexportTimeout,
    Duration unexportWait,
    int registryPort,
    RestartPolicy restartPolicy,
    ExecPolicy execPolicy) {

  /** Component of every entry. */
  static final String COMPONENT = "org.dfra.river.phoenix";

  /** Default TCP port of the activation system. */
  static final int DEFAULT_PORT = StopLocator.DEFAULT_PORT;

  /** Activation includes the start of a virtual machine, so it may take longer than other calls. */
  private static final long ACTIVATION_DEADLINE_MILLIS = 30_000;

  private static final long REGISTRATION_DEADLINE_MILLIS = 10_000;
  private static final long STOP_DEADLINE_MILLIS = 3_000;

  /** The folder of the journal. */
  static Path folder(Configuration c) throws ConfigurationException {
    return Path.of(entry(c, "persistenceDirectory", String.class));
  }

  /**
   * Reads the entries, with defaults for all but the persistence directory.
   *
   * @param identities under which the default exporters export the system and the monitor
   */
  static PhoenixConfiguration read(Configuration c, SecretIdentities identities)
      throws ConfigurationException {
    try {
      return readEntries(c, identities);
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(COMPONENT + ": " + e.getMessage(), e);
    }
  }

  /** The file with the output of a group's process. */
  Path output(String group) {
    return outputDirectory.resolve(group + ".log");
  }

  /** Prepares a group's instantiator before its first call. */
  ActivationInstantiator prepareInstantiator(ActivationInstantiator raw) throws RemoteException {
    return (ActivationInstantiator) instantiatorPreparer.prepareProxy(raw);
  }

  private static PhoenixConfiguration readEntries(Configuration c, SecretIdentities identities)
      throws ConfigurationException {
    Path journal = folder(c);
    String host = entry(c, "host", String.class, "localhost");
    int port = number(c, "port", DEFAULT_PORT, 1);
    RestartPolicy restart = RestartPolicy.DEFAULT;
    ExecPolicy exec = ExecPolicy.DEFAULT;
    return new PhoenixConfiguration(
        journal,
        Path.of(entry(c, "outputDirectory", String.class, journal.resolve("output").toString())),
        number(c, "persistenceSnapshotThreshold", 200, 1),
        optional(c, "loginContext", LoginContext.class),
        exporter(
            c,
            "activatorExporter",
            exporter(host, port, PhoenixIdentities.ACTIVATOR, ACTIVATION_DEADLINE_MILLIS)),
        exporter(
            c,
            "systemExporter",
            exporter(host, port, identities.system(), REGISTRATION_DEADLINE_MILLIS)),
        exporter(
            c,
            "monitorExporter",
            exporter(host, port, identities.monitor(), REGISTRATION_DEADLINE_MILLIS)),
        exporter(
            c, "stopExporter", exporter(host, port, StopLocator.IDENTITY, STOP_DEADLINE_MILLIS)),
        entry(c, "instantiatorPreparer", ProxyPreparer.class, new BasicProxyPreparer()),
        optional(c, "groupConfig", String[].class),
        optional(c, "groupLocation", String.class),
        List.of(entry(c, "groupOptions", String[].class, new String[0])),
        millis(c, "groupTimeout", Duration.ofSeconds(60)),
        number(c, "groupThrottle", 3, 1),
        millis(c, "unexportTimeout", Duration.ofSeconds(5)),
        millis(c, "unexportWait", Duration.ofMillis(10)),
        number(c, "registryPort", -1, -1),
        new RestartPolicy(
            millis(c, "restartDelay", restart.initialDelay()),
            millis(c, "restartMaxDelay", restart.maxDelay()),
            number(c, "restartLimit", restart.crashLimit(), 2),
            millis(c, "restartWindow", restart.window()),
            millis(c, "restartHoldOff", restart.holdOff()),
            millis(c, "restartMinReady", restart.minReadyTime())),
        new ExecPolicy(
            entry(c, "customGroups", boolean.class, exec.customGroups()),
            texts(c, "permittedCommands", exec.commands()),
            texts(c, "permittedOptions", exec.options()),
            texts(c, "permittedProperties", exec.properties()),
            texts(c, "permittedClassPaths", exec.classPaths()),
            texts(c, "permittedOptionsFiles", List.of()).stream().map(Path::of).toList()));
  }

  private static Exporter exporter(String host, int port, Uuid identity, long deadlineMillis) {
    return JeriExporters.keepingAlive(
        Endpoints.tcp(host, port), new DeadlineILFactory(deadlineMillis), identity);
  }

  private static Exporter exporter(Configuration c, String name, Exporter fallback)
      throws ConfigurationException {
    return JeriExporters.requireNoDistributedGc(entry(c, name, Exporter.class, fallback), name);
  }

  private static <T> T entry(Configuration c, String name, Class<T> type)
      throws ConfigurationException {
    return cast(c.getEntry(COMPONENT, name, type));
  }

  private static <T> T entry(Configuration c, String name, Class<T> type, T fallback)
      throws ConfigurationException {
    Object value = c.getEntry(COMPONENT, presentOrOld(c, name, type), type, fallback);
    if (value == null) {
      throw new ConfigurationException(
          COMPONENT + "." + name + " is null; give it a value or leave it out");
    }
    return cast(value);
  }

  /** The old name of an entry if the configuration has that. */
  private static String presentOrOld(Configuration c, String name, Class<?> type)
      throws ConfigurationException {
    @Nullable String old = RenamedNames.oldName(COMPONENT, name);
    if (old == null || !has(c, old, type)) {
      return name;
    }
    if (has(c, name, type)) {
      throw new ConfigurationException(
          COMPONENT + "." + name + " and its old name " + old + " are set; delete " + old);
    }
    RenamedNames.warn("phoenix' configuration", "the entry", COMPONENT + "." + old, name);
    return old;
  }

  private static boolean has(Configuration c, String name, Class<?> type)
      throws ConfigurationException {
    try {
      Object unused = c.getEntry(COMPONENT, name, type);
      return true;
    } catch (NoSuchEntryException e) {
      return false;
    }
  }

  @SuppressWarnings("NullAway") // getEntry takes a null default
  private static <T> @Nullable T optional(Configuration c, String name, Class<T> type)
      throws ConfigurationException {
    return type.cast(c.getEntry(COMPONENT, name, type, null));
  }

  private static List<String> texts(Configuration c, String name, List<String> fallback)
      throws ConfigurationException {
    return List.of(entry(c, name, String[].class, fallback.toArray(String[]::new)));
  }

  private static Duration millis(Configuration c, String name, Duration fallback)
      throws ConfigurationException {
    long millis = entry(c, name, long.class, fallback.toMillis());
    if (millis < 1) {
      throw new ConfigurationException(
          COMPONENT + "." + name + " = " + millis + " ms < 1 ms; give 1 ms or more");
    }
    return Duration.ofMillis(millis);
  }

  private static int number(Configuration c, String name, int fallback, int min)
      throws ConfigurationException {
    int value = entry(c, name, int.class, fallback);
    if (value < min) {
      throw new ConfigurationException(COMPONENT + "." + name + " = " + value + " < " + min);
    }
    return value;
  }

  @SuppressWarnings("unchecked") // the configuration has checked it; T may be a primitive's class
  private static <T> T cast(Object value) {
    return (T) value;
  }
}
