package org.dfra.core.config;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * A module's parameters: named texts, each with its place in the configuration, so that every error
 * message can name file and line. Immutable.
 */
public final class Parameters implements Serializable {

  private static final long serialVersionUID = 1L;

  /**
   * One parameter.
   *
   * @param text the configured value, after substitution
   * @param place its place in the configuration
   */
  public record Value(String text, SourceLocation place) implements Serializable {}

  /** Is notified of a driver's accesses. */
  public interface ParameterAccessListener {

    /** A parameter is read, whether it is set or not. */
    void onRead(String name);

    /**
     * A parameter names another module of the robot; if it is not set, the first module of the kind
     * is used.
     *
     * @param kind the required type of the other module
     */
    default void onModuleReference(String name, Class<?> kind) {}

    /** A parameter's value is invalid or missing; the read is about to fail. */
    default void onInvalid(String name) {}
  }

  private final String owner;
  private final TreeMap<String, Value> values;

  /** Null in deserialized objects. */
  private final transient @Nullable ParameterAccessListener listener;

  /**
   * @param owner the module that has these parameters, for messages: {@code robot/name}
   * @param values the parameters by name
   */
  public Parameters(String owner, Map<String, Value> values) {
    this(owner, new TreeMap<>(values), null);
  }

  private Parameters(
      String owner, TreeMap<String, Value> values, @Nullable ParameterAccessListener listener) {
    this.owner = owner;
    this.values = values;
    this.listener = listener;
  }

  /**
   * Parameters given in code, for tests and examples; their place is {@link SourceLocation#CODE}.
   */
  public static Parameters of(String owner, Map<String, String> texts) {
    Map<String, Value> values = new TreeMap<>();
    texts.forEach((name, text) -> values.put(name, new Value(text, SourceLocation.CODE)));
    return new Parameters(owner, values);
  }

  /** A copy that notifies a listener of accesses. */
  public Parameters withListener(ParameterAccessListener listener) {
    return new Parameters(owner, values, listener);
  }

  /** A copy without one parameter, to test whether the driver needs it. */
  public Parameters without(String name) {
    TreeMap<String, Value> others = new TreeMap<>(values);
    others.remove(name);
    return new Parameters(owner, others, listener);
  }

  /** These parameters by their new names, for the module's implementation class. */
  Parameters withoutOldNames(String implementation) {
    ConfigurationFaults faults = new ConfigurationFaults();
    TreeMap<String, Value> resolved =
        new TreeMap<>(RenamedNames.resolveParameters(implementation, values, faults));
    faults.throwIfAny();
    return resolved.equals(values) ? this : new Parameters(owner, resolved, listener);
  }

  /** The parameter's text. */
  public Optional<String> find(String name) {
    return Optional.ofNullable(read(name)).map(Value::text);
  }

  /**
   * The name of another module of the robot.
   *
   * @param kind the required type of the other module
   * @return empty if it is not set: then any module of the kind is suitable
   */
  public Optional<String> moduleName(String name, Class<?> kind) {
    if (listener != null) {
      listener.onModuleReference(name, kind);
    }
    return find(name);
  }

  /** The parameter's place in the configuration. */
  public Optional<SourceLocation> place(String name) {
    return Optional.ofNullable(values.get(name)).map(Value::place);
  }

  /**
   * The parameter's text.
   *
   * @throws ConfigurationException if it is not set
   */
  public String text(String name) {
    return value(name).text();
  }

  /**
   * A number at least {@code min} and at most {@code max}.
   *
   * @throws ConfigurationException if it is set and is not such a number
   */
  public double number(String name, double defaultValue, double min, double max) {
    return number(name, defaultValue, min, max, "a number");
  }

  /**
   * A time span in seconds, decimals allowed, at least {@code min} and at most {@code max}.
   *
   * @throws ConfigurationException if it is set and is not such a time span
   */
  public Duration seconds(String name, Duration fallback, Duration min, Duration max) {
    double seconds =
        number(name, seconds(fallback), seconds(min), seconds(max), "a number of seconds");
    return Duration.ofNanos(Math.round(seconds * 1e9));
  }

  /** An exception for a parameter's value that only the driver can check. */
  public ConfigurationException fault(String name, String expected, @Nullable Throwable cause) {
    return fault(name, value(name), expected, cause);
  }

  /** All parameters by name, in alphabetical order. */
  public Map<String, Value> all() {
    return Collections.unmodifiableMap(values);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof Parameters that
        && owner.equals(that.owner)
        && values.equals(that.values);
  }

  @Override
  public int hashCode() {
    return Objects.hash(owner, values);
  }

  /** {@code owner {name=text, …}}, without passwords: this may be logged. */
  @Override
  public String toString() {
    return values.entrySet().stream()
        .map(
            entry ->
                entry.getKey()
                    + "="
                    + (entry.getKey().contains("password") ? "…" : entry.getValue().text()))
        .collect(Collectors.joining(", ", owner + " {", "}"));
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (owner == null || values == null) {
      throw new InvalidObjectException("parameters without an owner or without values");
    }
  }

  private double number(String name, double defaultValue, double min, double max, String kind) {
    Value value = read(name);
    if (value == null) {
      return defaultValue;
    }
    String expected = kind + " from " + plain(min) + " to " + plain(max);
    try {
      // Not Double.parseDouble: it also takes "0x1p3", "9f" and "NaN".
      double number = new BigDecimal(value.text().trim()).doubleValue();
      if (number >= min && number <= max) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw fault(name, value, expected, e);
    }
    throw fault(name, value, expected, null);
  }

  /** 9600 rather than 9600.0. */
  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? Long.toString((long) number)
        : Double.toString(number);
  }

  private @Nullable Value read(String name) {
    if (listener != null) {
      listener.onRead(name);
    }
    return values.get(name);
  }

  private Value value(String name) {
    Value value = read(name);
    if (value == null) {
      if (listener != null) {
        listener.onInvalid(name);
      }
      throw new ConfigurationException(
          owner
              + ": parameter "
              + name
              + " is not set; write parameter."
              + name
              + "=… in the module's properties or <parameter name=\""
              + name
              + "\"> in the robot's XML");
    }
    return value;
  }

  private ConfigurationException fault(
      String name, Value value, String expected, @Nullable Throwable cause) {
    if (listener != null) {
      listener.onInvalid(name);
    }
    String message =
        value.place()
            + ": "
            + owner
            + ": parameter "
            + name
            + " is \""
            + value.text()
            + "\", which is not "
            + expected;
    return cause == null
        ? new ConfigurationException(message)
        : new ConfigurationException(message, cause);
  }

  private static double seconds(Duration duration) {
    return duration.toNanos() / 1e9;
  }
}
