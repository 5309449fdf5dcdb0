package org.dfra.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * A dynamic archive of Java 17 leaves out classes that are older than Java 6, as River's are, and
 * all that extend one. If it leaves out an outer class, but has one that is nested in it, a lambda
 * of the nested class crashes the virtual machine that starts from the archive (SIGSEGV in {@code
 * load_shared_lambda_proxy_class}). So no such class has a lambda.
 */
class ArchivedLambdasTest {

  private static final int JAVA_6 = 50; // major version of the form of class files
  private static final int MAJOR_AT = 6;

  private final Map<Class<?>, Boolean> archived = new HashMap<>();

  @Test
  void noLambdaHasAnOuterClassThatAnArchiveLeavesOut() {
    List<Class<?>> all =
        new ClassFileImporter()
                .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                .importPackages("org.dfra")
                .stream()
                .<Class<?>>map(JavaClass::reflect)
                .toList();

    assertThat(all.stream().filter(each -> !isArchived(each)))
        .as("classes that an archive leaves out, or this test finds nothing")
        .isNotEmpty();
    assertThat(all.stream().filter(this::crashes))
        .as("make these classes top-level, or have them use no lambda")
        .isEmpty();
  }

  private boolean crashes(Class<?> type) {
    return isArchived(type)
        && !isArchived(type.getNestHost())
        && new String(bytes(type), StandardCharsets.ISO_8859_1).contains("LambdaMetafactory");
  }

  private boolean isArchived(Class<?> type) {
    Boolean known = archived.get(type);
    if (known == null) {
      known =
          isNewEnough(type)
              && Stream.concat(
                      Stream.ofNullable(type.getSuperclass()), Stream.of(type.getInterfaces()))
                  .allMatch(this::isArchived);
      archived.put(type, known);
    }
    return known;
  }

  private static boolean isNewEnough(Class<?> type) {
    return type.getClassLoader() == null
        || ByteBuffer.wrap(bytes(type)).getShort(MAJOR_AT) >= JAVA_6;
  }

  private static byte[] bytes(Class<?> type) {
    String file = type.getName().replace('.', '/') + ".class";
    try (InputStream in = type.getClassLoader().getResourceAsStream(file)) {
      if (in == null) {
        throw new IOException(file + " is missing");
      }
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
