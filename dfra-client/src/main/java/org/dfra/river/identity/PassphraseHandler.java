package org.dfra.river.identity;

import java.io.Console;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import javax.security.auth.callback.Callback;
import javax.security.auth.callback.CallbackHandler;
import javax.security.auth.callback.ConfirmationCallback;
import javax.security.auth.callback.NameCallback;
import javax.security.auth.callback.PasswordCallback;
import javax.security.auth.callback.TextOutputCallback;
import javax.security.auth.callback.UnsupportedCallbackException;

/**
 * Answers the questions of login modules: names by their default, passphrases from the file of the
 * identity's passphrase, or else by asking once on the terminal.
 */
final class PassphraseHandler implements CallbackHandler {

  private final Path folder;
  private final Optional<char[]> passphrase;

  /**
   * @param folder of the identity, for messages
   * @param passphrase from its file; empty if there is none
   */
  PassphraseHandler(Path folder, Optional<char[]> passphrase) {
    this.folder = folder;
    this.passphrase = passphrase;
  }

  @Override
  public void handle(Callback[] callbacks) throws IOException, UnsupportedCallbackException {
    char[] answer = null;
    for (Callback each : callbacks) {
      if (each instanceof NameCallback name) {
        name.setName(
            Optional.ofNullable(name.getDefaultName()).orElse(SecurityFiles.IDENTITY_ALIAS));
      } else if (each instanceof PasswordCallback password) {
        answer = answer == null ? passphrase() : answer;
        password.setPassword(answer);
      } else if (each instanceof ConfirmationCallback confirmation) {
        confirmation.setSelectedIndex(confirmation.getDefaultOption());
      } else if (!(each instanceof TextOutputCallback)) { // its text would only repeat the prompt
        throw new UnsupportedCallbackException(each);
      }
    }
    if (answer != null) {
      Arrays.fill(answer, ' ');
    }
  }

  private char[] passphrase() throws IOException {
    if (passphrase.isPresent()) {
      return passphrase.get().clone();
    }
    Console console = System.console();
    char[] typed =
        console == null
            ? null
            : console.readPassword("Passphrase of %s: ", folder.resolve(SecurityFiles.IDENTITY));
    if (typed == null) {
      throw new IOException(
          folder.resolve(SecurityFiles.IDENTITY_PASSPHRASE)
              + " is missing, and there is no terminal on which to ask for the passphrase");
    }
    return typed;
  }
}
