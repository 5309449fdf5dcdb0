package java.rmi.activation;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.rmi.MarshalledObject;
import java.util.Arrays;
import java.util.Objects;
import java.util.Properties;

/**
 * How to start a group's JVM: the group's class and data, system properties, and the command.
 *
 * <p>Immutable; the properties are copied on the way in and out.
 */
public final class ActivationGroupDesc implements Serializable {

  private static final long serialVersionUID = -4936225423168276595L;

  /**
   * @serial the group's class, or null for the daemon's own
   */
  private final String className;

  /**
   * @serial the codebase of the class: URLs separated by spaces, or null
   */
  private final String location;

  /** @serial the argument of the group's constructor, or null */
  private final MarshalledObject<?> data;

  /**
   * @serial the command that starts the JVM, or null for the daemon's own
   */
  private final CommandEnvironment env;

  /**
   * @serial system properties of the JVM, or null
   */
  private final Properties props;

  /**
   * A group of the daemon's default class.
   *
   * @param overrides system properties of the group's JVM, or null
   * @param cmd the command that starts it, or null for the daemon's own
   */
  public ActivationGroupDesc(Properties overrides, CommandEnvironment cmd) {
    this(null, null, null, overrides, cmd);
  }

  /**
   * A group of any class.
   *
   * @param className a subclass of {@link ActivationGroup}, fully qualified, or null for the
   *     daemon's own
   * @param location the codebase of the class: URLs separated by spaces, or null
   * @param data the argument of the group's constructor, or null
   * @param overrides system properties of the group's JVM, or null
   * @param cmd the command that starts it, or null for the daemon's own
   */
  public ActivationGroupDesc(
      String className,
      String location,
      MarshalledObject<?> data,
      Properties overrides,
      CommandEnvironment cmd) {
    this.className = className;
    this.location = location;
    this.data = data;
    this.env = cmd;
    this.props = copy(overrides);
  }

  private static Properties copy(Properties properties) {
    return properties == null ? null : (Properties) properties.clone();
  }

  /**
   * The group's class.
   *
   * @return its fully qualified name, or null for the daemon's own
   */
  public String getClassName() {
    return className;
  }

  /**
   * The codebase of the class.
   *
   * @return URLs separated by spaces, or null
   */
  public String getLocation() {
    return location;
  }

  /**
   * The argument of the group's constructor.
   *
   * @return the data, still marshalled, or null
   */
  public MarshalledObject<?> getData() {
    return data;
  }

  /**
   * System properties of the group's JVM.
   *
   * @return a copy, or null if none were given
   */
  public Properties getPropertyOverrides() {
    return copy(props);
  }

  /**
   * The command that starts the group's JVM.
   *
   * @return the command, or null for the daemon's own
   */
  public CommandEnvironment getCommandEnvironment() {
    return env;
  }

  /**
   * Whether both descriptors are equal.
   *
   * @param other anything
   * @return true for an ActivationGroupDesc equal in class, location, data, command and properties
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof ActivationGroupDesc that
        && Objects.equals(className, that.className)
        && Objects.equals(location, that.location)
        && Objects.equals(data, that.data)
        && Objects.equals(env, that.env)
        && Objects.equals(props, that.props);
  }

  /**
   * Computed from all parts.
   *
   * @return equal for equal descriptors
   */
  @Override
  public int hashCode() {
    return Objects.hash(className, location, data, env, props);
  }

  /**
   * The command that starts a group's JVM: the executable and its options.
   *
   * <p>Immutable; the options are copied on the way in and out.
   */
  public static class CommandEnvironment implements Serializable {

    private static final long serialVersionUID = 6165754737887770191L;

    /**
     * @serial path of the java executable, or null for the daemon's own
     */
    private final String command;

    /**
     * @serial options of the executable; a stream with null is read as without options
     */
    private String[] options;

    /**
     * A command.
     *
     * @param cmdpath path of the java executable, or null for the daemon's own
     * @param argv its options, one element each; null is the same as none
     */
    public CommandEnvironment(String cmdpath, String[] argv) {
      command = cmdpath;
      options = argv == null ? new String[0] : argv.clone();
    }

    /**
     * The executable.
     *
     * @return its path, or null for the daemon's own
     */
    public String getCommandPath() {
      return command;
    }

    /**
     * Its options.
     *
     * @return a copy, never null
     */
    public String[] getCommandOptions() {
      return options.clone();
    }

    /**
     * Whether both are the same command.
     *
     * @param other anything
     * @return true for a CommandEnvironment equal in path and options
     */
    @Override
    public boolean equals(Object other) {
      return other instanceof CommandEnvironment that
          && Objects.equals(command, that.command)
          && Arrays.equals(options, that.options);
    }

    /**
     * Computed from both parts.
     *
     * @return equal for equal commands
     */
    @Override
    public int hashCode() {
      return 31 * Objects.hashCode(command) + Arrays.hashCode(options);
    }

    private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
      in.defaultReadObject();
      // A copy, since a forged stream may keep a second reference to the array.
      options = options == null ? new String[0] : options.clone();
    }
  }
}
