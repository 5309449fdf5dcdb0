package org.dfra.river.registrar;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** Access to the fields of reggie 2.2.2, which has no method to read its contents. */
public final class ReggieFields {

  private static final String CLASS = "com.sun.jini.reggie.RegistrarImpl";

  private ReggieFields() {}

  /**
   * The class that declares reggie's fields.
   *
   * @param reggie the lookup service
   * @throws NoSuchFieldException if it is not reggie
   */
  public static Class<?> owner(Object reggie) throws NoSuchFieldException {
    Class<?> type = reggie.getClass();
    while (type != null && !type.getName().equals(CLASS)) {
      type = type.getSuperclass();
    }
    if (type == null) {
      throw new NoSuchFieldException(reggie.getClass().getName() + " is no " + CLASS);
    }
    return type;
  }

  /** A field of a class, whatever its access. */
  public static Field accessible(Class<?> type, String name) throws NoSuchFieldException {
    Field field = type.getDeclaredField(name);
    field.setAccessible(true);
    return field;
  }

  /** The value of a field from {@link #accessible}. */
  static @Nullable Object value(Field field, Object of) {
    try {
      return field.get(of);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /** The value of an integer field from {@link #accessible}. */
  static long number(Field field, Object of) {
    try {
      return field.getLong(of);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /**
   * A method of a class, whatever its access.
   *
   * @throws NoSuchMethodException if the class declares none
   */
  static Method method(Class<?> type, String name, Class<?>... parameters)
      throws NoSuchMethodException {
    Method method = type.getDeclaredMethod(name, parameters);
    method.setAccessible(true);
    return method;
  }

  /**
   * Calls a method from {@link #method}.
   *
   * @param on null for a static method
   * @throws RuntimeException as the method throws it
   */
  static @Nullable Object call(Method method, @Nullable Object on, @Nullable Object... args) {
    try {
      return method.invoke(on, args);
    } catch (InvocationTargetException e) {
      throw thrown(e);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /** An object of a constructor that was made accessible. */
  static Object made(Constructor<?> constructor, @Nullable Object... args) {
    try {
      return constructor.newInstance(args);
    } catch (InvocationTargetException e) {
      throw thrown(e);
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e); // it is a class, and was made accessible
    }
  }

  private static RuntimeException thrown(InvocationTargetException e) {
    @Nullable Throwable cause = e.getCause();
    if (cause instanceof Error error) {
      throw error;
    }
    return cause instanceof RuntimeException exception
        ? exception
        : new IllegalStateException(cause);
  }

  /** Sets a field from {@link #accessible}. */
  static void set(Field field, Object of, @Nullable Object value) {
    try {
      field.set(of, value);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /** The value of a field from {@link #accessible} that always has one. */
  static Object present(Field field, Object of) {
    return Objects.requireNonNull(value(field, of), field.getName());
  }
}
