package org.dfra.core.module;

import java.lang.reflect.InvocationTargetException;
import java.util.Arrays;
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
              + " is no "
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
    try {
      return Class.forName(name, true, Thread.currentThread().getContextClassLoader());
    } catch (ClassNotFoundException e) {
      throw fault(
          what
              + " class "
              + name
              + " is not on the group's class path; add its jar or mend the name",
          e);
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
}
