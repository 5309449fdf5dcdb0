package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.PersonaAttributes;
import org.junit.jupiter.api.Test;

/** A query may name whatever dfra-api declares. */
class QueryTypeNamesTest {

  private static final JavaClasses API =
      new ClassFileImporter()
          .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
          .withImportOption(location -> location.contains("dfra-api"))
          .importPackages("org.dfra");

  private static Set<Class<?>> declared(Predicate<JavaClass> wanted) {
    return API.stream().filter(wanted).map(JavaClass::reflect).collect(Collectors.toSet());
  }

  @Test
  void knowsEveryKindOfModule() {
    assertThat(QueryTypeNames.standard().kinds())
        .containsExactlyInAnyOrderElementsOf(
            declared(type -> type.isInterface() && type.isAssignableTo(Module.class)).stream()
                .<Class<? extends Module>>map(type -> type.asSubclass(Module.class))
                .toList());
  }

  @Test
  void knowsEveryAttributeOfModules() {
    assertThat(QueryTypeNames.standard().attributes())
        .containsExactlyInAnyOrderElementsOf(
            declared(
                    type ->
                        type.isRecord()
                            && type.isAssignableTo(Attributes.class)
                            && !type.isEquivalentTo(PersonaAttributes.class)) // a robot's
                .stream()
                .<Class<? extends Attributes>>map(type -> type.asSubclass(Attributes.class))
                .toList());
  }
}
