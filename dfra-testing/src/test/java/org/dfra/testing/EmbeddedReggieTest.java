package org.dfra.testing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.ConnectException;
import java.time.Duration;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceTemplate;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.extension.RegisterExtension;

class EmbeddedReggieTest {

  @RegisterExtension static final EmbeddedReggie FOR_THE_CLASS = new EmbeddedReggie();
  @RegisterExtension final EmbeddedReggie forTheTest = new EmbeddedReggie();

  @Test
  void isALookupServiceOfItsOwn() throws Exception {
    LookupLocator locator = new LookupLocator(FOR_THE_CLASS.locator());
    assertThat(locator.getHost()).isEqualTo("127.0.0.1");
    assertThat(locator.getPort()).isEqualTo(FOR_THE_CLASS.port()).isNotEqualTo(4160);
    assertThat(locator.getRegistrar()).isEqualTo(FOR_THE_CLASS.registrar());
    assertThat(FOR_THE_CLASS.registrar().getGroups()).containsExactly(FOR_THE_CLASS.group());
    assertThat(
            FOR_THE_CLASS.registrar().lookup(new ServiceTemplate(null, null, null), 9).totalMatches)
        .as("services: itself")
        .isEqualTo(1);
  }

  @Test
  void twoOfThemAreStrangers() {
    assertThat(forTheTest.registrar()).isNotEqualTo(FOR_THE_CLASS.registrar());
    assertThat(forTheTest.port()).isNotEqualTo(FOR_THE_CLASS.port());
    assertThat(forTheTest.group()).isNotEqualTo(FOR_THE_CLASS.group());
  }

  @Test
  void isGoneWhenItIsClosed() throws Exception {
    EmbeddedReggie reggie = new EmbeddedReggie();
    assertThatThrownBy(reggie::registrar)
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("the embedded reggie does not run; start it first");
    reggie.close();
    reggie.start();
    LookupLocator locator = new LookupLocator(reggie.locator());
    assertThat(reggie.start().locator()).as("started twice").isEqualTo(reggie.locator());
    reggie.close();
    reggie.close();
    assertThatThrownBy(locator::getRegistrar).isInstanceOf(ConnectException.class);
    assertThatThrownBy(reggie::locator).isInstanceOf(IllegalStateException.class);
  }

  /** It goes on for a class within the class. */
  @Nested
  @TestMethodOrder(MethodOrderer.OrderAnnotation.class)
  class Within {

    @Test
    @Order(1)
    void theClassesOneGoesOn() {
      assertThat(FOR_THE_CLASS.registrar()).isNotNull();
    }

    @Test
    @Order(2)
    void alsoForTheNextTest() {
      assertThat(FOR_THE_CLASS.registrar()).isNotNull();
    }
  }

  /** After a class within the class. */
  @Test
  void goesOnAsLongAsTheClass() throws Exception {
    assertThat(new LookupLocator(FOR_THE_CLASS.locator()).getRegistrar()).isNotNull();
  }

  @Test
  void suppliesADirectory() throws Exception {
    try (JiniModuleDirectory own = forTheTest.directory()) {
      assertThat(own.findFirst(ModuleQuery.of(Module.class), Duration.ofMillis(50))).isEmpty();
    }
  }
}
