package org.dfra.recruit.river;

import java.util.List;
import net.jini.core.entry.Entry;
import org.dfra.river.entry.EntryClassProvider;

/** Registers the entry of this package for module descriptions. */
public final class RecruitmentEntryKinds implements EntryClassProvider {

  /** Called by the service loader. */
  public RecruitmentEntryKinds() {}

  @Override
  public List<Class<? extends Entry>> entryClasses() {
    return List.of(RecruitmentEntry.class);
  }
}
