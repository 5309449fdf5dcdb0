package org.dfra.core.module;

import java.lang.reflect.InvocationTargetException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.stream.Collectors;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.jspecify.annotations.Nullable;

/**
 * Creates the objects whose classes a module's description names. A failure is reported with the
 * place that names the class.
 */
public final class ModuleClassFactory {

  private final ModuleDescription description;

  /** A factory for one module. */
  public ModuleClassFactory(ModuleDescription description) {
    this.description = description;
  }

  /**
   * Creates the driver, not started.
   *
   * @param kind the interface that it must implement
   * @param base the class that it must extend
   * @throws ConfigurationException if there is no such class, it is not such a driver, or it cannot
   *     be constructed from the configured parameters, with every fault in these, a line each; a
   *     driver reads all of its parameters in its constructor, so one that it did not read is
   *     treated as a typo
   */
  public ModuleImpl createDriver(
      ModuleContext context, Class<?> kind, Class<? extends ModuleImpl> base) {
    return createDriver(context, kind, base, (parameter, needed) -> {});
  }

  /**
   * The same.
   *
   * @param needs receives each other module that the driver needs: the parameter that may name it,
   *     and its required type
   */
  public ModuleImpl createDriver(
      ModuleContext context,
      Class<?> kind,
      Class<? extends ModuleImpl> base,
      BiConsumer<String, Class<?>> needs) {
    Class<?> type = load("driver", description.driverClass());
    if (!base.isAssignableFrom(type) || !kind.isAssignableFrom(type)) {
      throw fault(
          "driver "
              + type.getName()
              + " is not a subclass of "
              + base.getSimpleName()
              + " that implements "
              + kind.getName(),
          null);
    }
    DriverFactory trial = new DriverFactory(description.path(), context, needs);
    return trial.construct(
        given ->
            (ModuleImpl) construct("driver", type, new Class<?>[] {ModuleContext.class}, given));
  }

  /**
   * Loads a class.
   *
   * @param what it is, for messages
   */
  public Class<?> load(String what, String name) {
    ClassLoader loader = Thread.currentThread().getContextClassLoader();
    try {
      return Class.forName(name, true, loader);
    } catch (ClassNotFoundException e) {
      String why =
          OptionalDrivers.missing(name, loader)
              .orElse("is not on the group's class path; add its jar or correct the name");
      throw fault(what + " class " + name + " " + why, e);
    } catch (LinkageError e) {
      throw fault(
          what + " class " + name + " cannot be loaded (" + e + "); add the jar that it needs", e);
    }
  }

  /**
   * Creates an object of a class by the public constructor with these parameters.
   *
   * @param what it is, for messages
   */
  public Object construct(
      String what, Class<?> type, Class<?>[] parameters, @Nullable Object... arguments) {
    try {
      return type.getConstructor(parameters).newInstance(arguments);
    } catch (NoSuchMethodException e) {
      throw fault(
          what
              + " "
              + type.getName()
              + " has no public constructor "
              + Arrays.stream(parameters)
                  .map(Class::getSimpleName)
                  .collect(Collectors.joining(", ", "(", ")")),
          e);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof ConfigurationException cause) {
        throw placed(cause);
      }
      throw fault(what + " " + type.getName() + " cannot be made: " + e.getCause(), e);
    } catch (ReflectiveOperationException e) {
      throw fault(what + " " + type.getName() + " cannot be made: " + e, e);
    }
  }

  /** A missing parameter has no place, so the module's place is used. */
  private ConfigurationException placed(ConfigurationException known) {
    return String.valueOf(known.getMessage()).startsWith(description.path() + ":")
        ? new ConfigurationException(description.place() + ": " + known.getMessage(), known)
        : known;
  }

  /** An exception about the module. */
  public ConfigurationException fault(String what, @Nullable Throwable cause) {
    String message = description.place() + ": module " + description.path() + ": " + what;
    return cause == null
        ? new ConfigurationException(message)
        : new ConfigurationException(message, cause);
  }

  /**
   * The drivers of DFRA that are in modules of their own, which a robot may lack. They are known
   * here only for the message that such a module is missing.
   */
  private static final class OptionalDrivers {

    /**
     * A module of the source.
     *
     * @param packages how the names of its classes begin
     * @param member one of its classes: if that is missing, the module is
     * @param remedy what to do about it
     */
    private record Optionally(String name, String packages, String member, String remedy) {}

    private static final List<Optionally> MODULES =
        List.of(
            new Optionally(
                "dfra-flight",
                "org.dfra.drivers.uav.",
                "org.dfra.drivers.uav.mavlink.MavlinkFlightImpl",
                "\"dist --flight\" packs it"));

    private OptionalDrivers() {}

    /**
     * Why a class is not there.
     *
     * @param className name of a class that the loader does not find
     * @return the end of a sentence that begins with the class; empty if the class does not belong
     *     to an optional module, or the module is installed and lacks only that class
     */
    static Optional<String> missing(String className, ClassLoader loader) {
      return MODULES.stream()
          .filter(each -> className.startsWith(each.packages()))
          .filter(each -> loader.getResource(each.member().replace('.', '/') + ".class") == null)
          .map(each -> "is in " + each.name() + ", which is not installed; " + each.remedy())
          .findFirst();
    }
  }
}
