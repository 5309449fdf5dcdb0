package org.dfra.core.module;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.dfra.core.config.NearestName;
import org.dfra.core.config.Parameters;
import org.dfra.module.Parameter;
import org.jspecify.annotations.Nullable;

/**
 * A module's parameters at run time: those its driver declares, with their current values, and the
 * other configured ones. A value set here is valid until the module ends; the configured value is
 * read when it starts.
 */
public final class ParameterTable {

  private final String module;
  private final Parameters written;
  private final Map<String, Declared> declared = new ConcurrentHashMap<>();

  private record Declared(String meaning, Supplier<String> get, @Nullable Consumer<String> set) {}

  ParameterTable(String module, Parameters written) {
    this.module = module;
    this.written = written;
  }

  /** Declares a parameter that can be read only. */
  public void declareReadOnly(String name, String meaning, Supplier<String> get) {
    declared.put(name, new Declared(meaning, get, null));
  }

  /**
   * Declares a text that can be set.
   *
   * @param set accepts a new value, or throws an IllegalArgumentException that names, as the rest
   *     of a sentence, what the value is not: {@code the name of a frame}
   */
  public void declareText(String name, String meaning, Supplier<String> get, Consumer<String> set) {
    declared.put(name, new Declared(meaning, get, set));
  }

  /** Declares a number that can be set. */
  public void declareNumber(
      String name, String description, NumberRange range, DoubleSupplier get, DoubleConsumer set) {
    declared.put(
        name,
        new Declared(
            description + ", " + range,
            () -> plain(get.getAsDouble()),
            text -> set.accept(range.parse(text))));
  }

  /**
   * The valid numbers of a parameter.
   *
   * @param min the minimum
   * @param max the maximum
   * @param unit the unit, such as {@code s}; may be empty
   * @param isInteger whether only whole numbers are valid
   */
  public record NumberRange(double min, double max, String unit, boolean isInteger) {

    /** Any number in a range. */
    public static NumberRange of(double least, double most, String unit) {
      return new NumberRange(least, most, unit, false);
    }

    /** Any whole number in a range. */
    public static NumberRange isInteger(int least, int most, String unit) {
      return new NumberRange(least, most, unit, true);
    }

    double parse(String text) {
      try {
        double number = new BigDecimal(text.trim()).doubleValue();
        if (number >= min && number <= max && (!isInteger || number == Math.rint(number))) {
          return number;
        }
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(toString(), e);
      }
      throw new IllegalArgumentException(toString());
    }

    /** {@code a whole number from 1 to 255 s}. */
    @Override
    public String toString() {
      return (isInteger ? "a whole number from " : "a number from ")
          + plain(min)
          + " to "
          + plain(max)
          + (unit.isEmpty() ? "" : " " + unit);
    }
  }

  /** All parameters with their current values, in alphabetical order. */
  List<Parameter> list() {
    TreeMap<String, Parameter> all = new TreeMap<>();
    written
        .all()
        .forEach(
            (name, value) ->
                all.put(
                    name,
                    new Parameter(name, value.text(), "as written, read at the start", false)));
    declared.forEach(
        (name, parameter) ->
            all.put(
                name,
                new Parameter(
                    name, parameter.get().get(), parameter.meaning(), parameter.set() != null)));
    return new ArrayList<>(all.values());
  }

  /**
   * Sets a parameter.
   *
   * @return its new value
   * @throws IllegalArgumentException if there is no such parameter, it cannot be set, or the text
   *     is not a valid value
   */
  String set(String name, String text) {
    Declared parameter = declared.get(name);
    if (parameter == null && written.find(name).isEmpty()) {
      throw new IllegalArgumentException(
          module
              + " has no parameter \""
              + name
              + "\""
              + NearestName.hint(name, names(), "; it has " + String.join(", ", names())));
    }
    if (parameter == null || parameter.set() == null) {
      throw new IllegalArgumentException(
          module
              + ": parameter "
              + name
              + " cannot be set while it runs; write it in the robot's XML and start the module"
              + " again");
    }
    try {
      parameter.set().accept(text);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          module
              + ": parameter "
              + name
              + " cannot be \""
              + text
              + "\", which is not "
              + e.getMessage(),
          e);
    }
    return parameter.get().get();
  }

  /** The names of all parameters, in alphabetical order. */
  List<String> names() {
    return list().stream().map(Parameter::name).toList();
  }

  /** 10 rather than 10.0. */
  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? Long.toString((long) number)
        : Double.toString(number);
  }
}
