// SPDX-License-Identifier: MIT
// The tables of a trace for SQL; docs/traces.md describes them for users.
#pragma once

namespace rasterloom::observe {

inline constexpr int kTraceFormat = 2;                // PRAGMA user_version
inline constexpr int kTraceApplication = 0x52617374;  // PRAGMA application_id: "Rast"

// Times are picoseconds of the machine's time since it began. Everything that points to a part of
// the machine is a component.id.
inline constexpr const char* kTraceTables = R"sql(
CREATE TABLE run (name TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE component (id INTEGER PRIMARY KEY, kind TEXT NOT NULL, name TEXT NOT NULL, node INTEGER, from_node INTEGER, to_node INTEGER);
CREATE TABLE activity (id INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE state_name (id INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE phase (number INTEGER PRIMARY KEY, frame INTEGER NOT NULL, phase INTEGER NOT NULL, name TEXT NOT NULL, began_ps INTEGER NOT NULL, ended_ps INTEGER NOT NULL);
CREATE TABLE state (component INTEGER NOT NULL, state INTEGER NOT NULL, activity INTEGER, from_ps INTEGER NOT NULL, to_ps INTEGER NOT NULL, because INTEGER);
CREATE TABLE message (event INTEGER NOT NULL, id INTEGER NOT NULL, kind INTEGER NOT NULL, bytes INTEGER NOT NULL, hops INTEGER NOT NULL, source INTEGER NOT NULL, carrier INTEGER NOT NULL, receiver INTEGER NOT NULL, queued_ps INTEGER NOT NULL, started_ps INTEGER NOT NULL, sent_ps INTEGER NOT NULL, delivered_ps INTEGER NOT NULL, consumed_ps INTEGER NOT NULL, parent INTEGER);
CREATE TABLE wait_cause (state INTEGER NOT NULL, component INTEGER NOT NULL, on_wire INTEGER NOT NULL, waits INTEGER NOT NULL, time_ps INTEGER NOT NULL);
CREATE TABLE node_summary (component INTEGER PRIMARY KEY, instructions INTEGER NOT NULL, cycles INTEGER NOT NULL, busy_ps INTEGER NOT NULL, waiting_input_ps INTEGER NOT NULL, waiting_output_ps INTEGER NOT NULL, waiting_phase_ps INTEGER NOT NULL, waiting_interrupt_ps INTEGER NOT NULL, asleep_ps INTEGER NOT NULL, messages_sent INTEGER NOT NULL, bytes_sent INTEGER NOT NULL, messages_received INTEGER NOT NULL, bytes_received INTEGER NOT NULL, peak_output_queue INTEGER NOT NULL, peak_input_queue INTEGER NOT NULL);
CREATE TABLE node_phase (component INTEGER NOT NULL, phase INTEGER NOT NULL, busy_ps INTEGER NOT NULL, PRIMARY KEY (component, phase)) WITHOUT ROWID;
CREATE TABLE link_summary (component INTEGER PRIMARY KEY, messages INTEGER NOT NULL, bytes INTEGER NOT NULL, busy_ps INTEGER NOT NULL, blocked_ps INTEGER NOT NULL, peak_output_queue INTEGER NOT NULL, peak_input_queue INTEGER NOT NULL);
CREATE TABLE part_summary (component INTEGER PRIMARY KEY, polygons INTEGER NOT NULL, words INTEGER NOT NULL, busy_ps INTEGER NOT NULL, blocked_ps INTEGER NOT NULL, waited_for TEXT, waited_for_ps INTEGER NOT NULL, input_peak INTEGER NOT NULL, input_full_ps INTEGER NOT NULL);
CREATE TABLE path (frame INTEGER PRIMARY KEY, began_ps INTEGER NOT NULL, ended_ps INTEGER NOT NULL);
CREATE TABLE path_step (frame INTEGER NOT NULL, step INTEGER NOT NULL, component INTEGER NOT NULL, on_wire INTEGER NOT NULL, from_ps INTEGER NOT NULL, to_ps INTEGER NOT NULL, PRIMARY KEY (frame, step)) WITHOUT ROWID;
CREATE TABLE path_activity (frame INTEGER NOT NULL, activity INTEGER NOT NULL, time_ps INTEGER NOT NULL, PRIMARY KEY (frame, activity)) WITHOUT ROWID;
CREATE TABLE path_line (frame INTEGER NOT NULL, file TEXT NOT NULL, line INTEGER NOT NULL, instructions INTEGER NOT NULL, time_ps INTEGER NOT NULL);
CREATE INDEX message_by_event ON message (event);
CREATE INDEX message_by_receiver ON message (receiver, delivered_ps);
CREATE INDEX message_by_carrier ON message (carrier, started_ps);
CREATE INDEX state_by_component ON state (component, from_ps);
CREATE VIEW timeline AS SELECT component.kind, component.name, state_name.name AS state, activity.name AS activity, from_ps, to_ps, cause.kind AS because_kind, cause.name AS because FROM state JOIN component ON component.id = state.component JOIN state_name ON state_name.id = state.state LEFT JOIN activity ON activity.id = state.activity LEFT JOIN component AS cause ON cause.id = state.because;
)sql";

}  // namespace rasterloom::observe
