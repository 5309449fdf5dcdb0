package org.dfra.authority;

import java.util.List;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Key stores of this process derive their keys by few rounds: tests write and read hundreds, and
 * each would take a tenth of a second. Readers take the number of rounds from the file.
 */
public final class QuickKeyStores implements BeforeAllCallback {

  private static final List<String> ROUNDS =
      List.of("keyPbeIterationCount", "certPbeIterationCount", "macIterationCount");

  @Override
  public void beforeAll(ExtensionContext context) {
    ROUNDS.forEach(each -> System.setProperty("keystore.pkcs12." + each, "10"));
  }
}
