/** Tests of the entries: what goes out as a record comes back as the same record. */
package org.dfra.river.entry;
