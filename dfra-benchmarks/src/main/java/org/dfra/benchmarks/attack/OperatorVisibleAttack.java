package org.dfra.benchmarks.attack;

import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** An attack whose effect may be visible to an operator. It runs commands meanwhile. */
abstract class OperatorVisibleAttack extends AttackTask {

  private @Nullable OperatorTerminal terminal;

  @Override
  protected void prepare(Target target) throws IOException {
    terminal = new OperatorTerminal(target);
  }

  /** The operator's terminal, after preparation. */
  final OperatorTerminal terminal() {
    OperatorTerminal made = terminal;
    if (made == null) {
      throw new IllegalStateException("not prepared");
    }
    return made;
  }
}
