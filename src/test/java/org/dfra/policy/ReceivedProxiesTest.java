package org.dfra.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.Serializable;
import java.lang.reflect.Field;
import java.lang.reflect.GenericArrayType;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.lang.reflect.WildcardType;
import java.rmi.Remote;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import net.jini.core.lease.Lease;
import org.junit.jupiter.api.Test;

/**
 * Each way by which a proxy reaches a process over the network, and what prepares the proxy before
 * its first call. A remote method that returns or takes something with a proxy in it needs a line.
 */
class ReceivedProxiesTest {

  @Test
  void eachHasItsPreparation() {
    Map<String, String> found = new TreeMap<>();
    for (Class<?> each : RemoteInterfaces.WITH_SUPERINTERFACES) {
      for (Method method : RemoteInterfaces.declared(each)) {
        String name = each.getSimpleName() + "." + method.getName();
        Set<Type> seen = new HashSet<>();
        if (canHaveProxy(method.getGenericReturnType(), seen)) {
          found.put(name + " returns", "");
        }
        if (Arrays.stream(method.getGenericParameterTypes())
            .anyMatch(type -> canHaveProxy(type, seen))) {
          found.put(name + " takes", "");
        }
      }
    }
    System.out.println(String.join("\n", found.keySet()));
    assertThat(found).isEmpty();
  }

  /** Whether an object of a declared type can be or contain a proxy. */
  private static boolean canHaveProxy(Type type, Set<Type> seen) {
    if (!seen.add(type)) {
      return false;
    } else if (type instanceof ParameterizedType generic) {
      return canHaveProxy(generic.getRawType(), seen)
          || Arrays.stream(generic.getActualTypeArguments())
              .anyMatch(each -> canHaveProxy(each, seen));
    } else if (type instanceof WildcardType wildcard) {
      return Arrays.stream(wildcard.getUpperBounds())
          .anyMatch(each -> each != Object.class && canHaveProxy(each, seen));
    } else if (type instanceof GenericArrayType array) {
      return canHaveProxy(array.getGenericComponentType(), seen);
    }
    return type instanceof Class<?> known && canHaveProxy(known, seen);
  }

  private static boolean canHaveProxy(Class<?> type, Set<Type> seen) {
    if (type.isArray()) {
      return canHaveProxy((Type) type.getComponentType(), seen);
    } else if (type == Object.class
        || Remote.class.isAssignableFrom(type)
        || Lease.class.isAssignableFrom(type)) {
      return true;
    } else if (type.isPrimitive() || type.isEnum() || type.getName().startsWith("java.")) {
      return false;
    }
    return Arrays.stream(type.getDeclaredFields())
            .filter(ReceivedProxiesTest::isSent)
            .anyMatch(each -> canHaveProxy(each.getGenericType(), seen))
        || (type.getSuperclass() != null
            && Serializable.class.isAssignableFrom(type.getSuperclass())
            && canHaveProxy(type.getSuperclass(), seen));
  }

  private static boolean isSent(Field field) {
    return !Modifier.isStatic(field.getModifiers()) && !Modifier.isTransient(field.getModifiers());
  }
}
